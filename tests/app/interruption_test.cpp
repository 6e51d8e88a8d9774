// Protects what was already computed: Ctrl-C in the middle ends the foreign programs, keeps the
// finished runs, and the next call goes on from there. So does a full results directory.
#include "tests/app/interrupted_call.hpp"
#include "tests/app/program.hpp"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <csignal>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using crossgrain::tests::Program;

namespace {

/// Starts the program in the background, sends SIGINT after `delay`, returns its exit status.
int interrupted_after(std::chrono::milliseconds delay, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), CROSSGRAIN_PROGRAM);
    std::vector<char*> argv;
    for (auto& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        execv(argv[0], argv.data());
        _exit(127);
    }
    std::this_thread::sleep_for(delay);
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

BOOST_AUTO_TEST_CASE(ctrl_c_keeps_what_is_finished) {
    const Program crossgrain;
    // The quick gas is finished at once; the bed of 4e9 steps never is.
    const auto quick = crossgrain.case_with("small-gas", "name = ", "name = ");
    const auto endless =
        crossgrain.case_with("small-bed", "time = 2.0\nframes = { every_time = 0.1 }",
                             "time = 4e6\nframes = { every_time = 1e3 }");
    const int status =
        interrupted_after(std::chrono::milliseconds(1500),
                          {"run", quick, endless, "--code", "native-dem", "--jobs", "2",
                           "--time-limit", "100", "--results", crossgrain.results().string()});
    BOOST_TEST(status == 130);
    BOOST_TEST(
        crossgrain({"run", quick, "--code", "native-dem"}).says("0 runs computed, 1 taken from"));
}

BOOST_AUTO_TEST_CASE(a_run_over_its_time_limit_fails_with_that_reason) {
    const Program crossgrain;
    const auto endless =
        crossgrain.case_with("small-bed", "time = 2.0\nframes = { every_time = 0.1 }",
                             "time = 4e6\nframes = { every_time = 1e3 }");
    const auto answer = crossgrain({"run", endless, "--code", "native-dem", "--time-limit", "0.5"});
    BOOST_TEST(answer.status == 3);
    BOOST_TEST(answer.says("time limit"));
}

BOOST_AUTO_TEST_CASE(every_signal_is_heard_while_the_program_waits_for_a_file) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) {
        crossgrain::tests::CallSite site;
        const auto pipe = site.directory() / "case.toml";  // that nobody writes
        BOOST_TEST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
        site.start({"run", pipe.string(), "--code", "native-dem"});
        std::this_thread::sleep_for(std::chrono::milliseconds(700));
        site.send(signal);
        const auto end = site.wait(30);
        BOOST_TEST(end.status == 130);
        // Heard, not ended by the watchdog after five seconds.
        BOOST_TEST(end.seconds < 4);
    }
}

BOOST_AUTO_TEST_CASE(a_second_signal_ends_the_program_at_once) {
    crossgrain::tests::CallSite site;
    const Program crossgrain;
    const auto endless =
        crossgrain.case_with("small-bed", "time = 2.0\nframes = { every_time = 0.1 }",
                             "time = 4e6\nframes = { every_time = 1e3 }");
    site.start({"run", endless, "--code", "native-dem"});
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    site.send(SIGHUP);
    site.send(SIGTERM);
    BOOST_TEST(site.wait(30).status == 130);
    BOOST_TEST(site.nobody_left());
    BOOST_TEST(crossgrain({"run", endless, "--time-limit", "0.1"}).status == 3);
}
