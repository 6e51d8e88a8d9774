// Programs that misbehave: each test starts a small shell script that does one thing wrong.
#include "adapters/process/find_program.hpp"
#include "adapters/process/log_file.hpp"
#include "adapters/process/process.hpp"
#include "adapters/process/question.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

namespace process = crossgrain::adapters::process;
using crossgrain::tests::TemporaryDirectory;
using process::Ending;

namespace {

process::Command shell(const TemporaryDirectory& directory, const std::string& script,
                       double time_limit = 20) {
    process::Command command;
    command.argv = {"sh", "-c", script};
    command.directory = directory.path();
    command.time_limit = time_limit;
    return command;
}

/// The same with a stream called "pipe", whose bytes are appended to `received`.
process::Command streaming(const TemporaryDirectory& directory, const std::string& script,
                           std::string& received, double time_limit = 20) {
    auto command = shell(directory, script, time_limit);
    command.stream_name = "pipe";
    command.on_stream = [&received](std::string_view bytes) { received += bytes; };
    return command;
}

/// Whether the process whose number is in a file is gone, within a second.
bool is_gone(const std::filesystem::path& number_file) {
    pid_t pid = 0;
    std::ifstream(number_file) >> pid;
    BOOST_TEST_REQUIRE(pid > 1);
    for (int attempt = 0; attempt < 100; ++attempt) {
        std::string name, state;
        std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
        // An orphan that nobody has reaped yet is dead as well.
        if (!(stat >> pid >> name >> state) || state == "Z" || state == "X") return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

}  // namespace

BOOST_AUTO_TEST_CASE(exit_status_output_and_directory) {
    const TemporaryDirectory directory;
    const auto result = process::run(shell(directory, "pwd; echo trouble >&2; exit 3"));
    BOOST_TEST((result.ending == Ending::exited));
    BOOST_TEST(result.status == 3);
    BOOST_TEST(process::tail(result.stdout_file, 5) ==
               std::filesystem::canonical(directory.path()).string());
    BOOST_TEST(process::tail(result.stderr_file, 5) == "trouble");
    BOOST_TEST(process::describe(result, 20) == "exit status 3");
}

BOOST_AUTO_TEST_CASE(death_by_signal) {
    const TemporaryDirectory directory;
    const auto result = process::run(shell(directory, "kill -SEGV $$"));
    BOOST_TEST((result.ending == Ending::signalled));
    BOOST_TEST(result.status == SIGSEGV);
    BOOST_TEST(process::describe(result, 20) == "killed by signal 11");
}

BOOST_AUTO_TEST_CASE(environment_is_inherited_and_replaced) {
    const TemporaryDirectory directory;
    auto command = shell(directory, "echo $CROSSGRAIN_A-$CROSSGRAIN_B; test -n \"$PATH\"");
    setenv("CROSSGRAIN_A", "inherited", 1);
    setenv("CROSSGRAIN_B", "old", 1);
    command.extra_environment = {"CROSSGRAIN_B=new"};
    const auto result = process::run(command);
    BOOST_TEST(result.status == 0);
    BOOST_TEST(process::tail(result.stdout_file, 1) == "inherited-new");
}

BOOST_AUTO_TEST_CASE(cpu_time_counts_children) {
    const TemporaryDirectory directory;
    const auto result = process::run(
        shell(directory, "sh -c 'i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done'; true"));
    BOOST_TEST(result.cpu_s > 0.02);
    BOOST_TEST(result.wall_s > 0.02);
}

BOOST_AUTO_TEST_CASE(hanging_program_and_its_grandchildren_are_killed) {
    const TemporaryDirectory directory;
    // All ignore SIGTERM, so that only SIGKILL helps.
    const auto result = process::run(shell(directory,
                                           "trap '' TERM\n"
                                           "sh -c 'echo $$ >grandchild; sleep 60; true' &\n"
                                           "while true; do sleep 1; done",
                                           0.4));
    BOOST_TEST((result.ending == Ending::time_limit));
    BOOST_TEST(result.wall_s >= 0.4);
    BOOST_TEST(result.wall_s < 5);
    BOOST_TEST(is_gone(directory.path() / "grandchild"));
    BOOST_TEST(process::describe(result, 0.4) == "killed at the time limit of 0.4 s");
}

BOOST_AUTO_TEST_CASE(orderly_end_on_sigterm_is_granted) {
    const TemporaryDirectory directory;
    const auto result = process::run(shell(
        directory, "trap 'echo saved >state; exit 0' TERM; while true; do sleep 0.05; done", 0.3));
    // LIGGGHTS exits with 0 when it is terminated: the ending must not be taken from the status.
    BOOST_TEST((result.ending == Ending::time_limit));
    BOOST_TEST(process::tail(directory.path() / "state", 1) == "saved");
}

BOOST_AUTO_TEST_CASE(suspended_program_is_killed) {
    const TemporaryDirectory directory;
    const auto result = process::run(shell(directory, "kill -STOP $$", 0.3));
    BOOST_TEST((result.ending == Ending::time_limit));
    BOOST_TEST(result.wall_s < 5);
}

BOOST_AUTO_TEST_CASE(what_the_leader_leaves_behind_is_killed) {
    const TemporaryDirectory directory;
    const auto result =
        process::run(shell(directory, "sh -c 'echo $$ >left; sleep 60; true' & "
                                      "while [ ! -s left ]; do sleep 0.01; done; exit 0"));
    BOOST_TEST((result.ending == Ending::exited));
    BOOST_TEST(result.wall_s < 5);
    BOOST_TEST(is_gone(directory.path() / "left"));
}

BOOST_AUTO_TEST_CASE(stop_request_ends_the_run) {
    const TemporaryDirectory directory;
    std::stop_source source;
    auto command = shell(directory, "sleep 60");
    command.stop = source.get_token();
    std::jthread stopper([&source] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        source.request_stop();
    });
    const auto result = process::run(command);
    BOOST_TEST((result.ending == Ending::stopped));
    BOOST_TEST(result.wall_s < 5);
    BOOST_TEST(process::describe(result, 20) == "stopped");
}

BOOST_AUTO_TEST_CASE(stream_arrives_complete_and_in_order) {
    const TemporaryDirectory directory;
    std::string received;
    // More than a pipe holds, and the program is gone as soon as it has written the last byte.
    const auto result = process::run(streaming(
        directory, "i=0; while [ $i -lt 300000 ]; do echo $i; i=$((i+1)); done >pipe", received));
    BOOST_TEST(result.status == 0);
    std::string expected;
    for (int i = 0; i < 300000; ++i)
        expected += std::to_string(i) + '\n';
    BOOST_TEST((received == expected));
}

BOOST_AUTO_TEST_CASE(stream_opened_twice_is_read_on) {
    const TemporaryDirectory directory;
    std::string received;
    const auto result =
        process::run(streaming(directory, "echo a >pipe; sleep 0.1; echo b >pipe", received));
    BOOST_TEST(result.status == 0);
    BOOST_TEST(received == "a\nb\n");
}

BOOST_AUTO_TEST_CASE(stream_never_opened_neither_hangs_nor_spins) {
    const TemporaryDirectory directory;
    std::string received;
    const std::clock_t before = std::clock();
    const auto result = process::run(streaming(directory, "sleep 0.5", received));
    const double own_cpu_s = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    BOOST_TEST(result.status == 0);
    BOOST_TEST(received.empty());
    BOOST_TEST(own_cpu_s < 0.2);
}

BOOST_AUTO_TEST_CASE(stream_closed_early_does_not_spin) {
    const TemporaryDirectory directory;
    std::string received;
    const std::clock_t before = std::clock();
    const auto result = process::run(streaming(directory, "echo a >pipe; sleep 0.5", received));
    const double own_cpu_s = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    BOOST_TEST(result.status == 0);
    BOOST_TEST(received == "a\n");
    BOOST_TEST(own_cpu_s < 0.2);
}

BOOST_AUTO_TEST_CASE(time_limit_holds_for_a_program_that_never_stops_writing) {
    const TemporaryDirectory directory;
    std::string received;
    const auto result =
        process::run(streaming(directory, "while true; do echo x; done >pipe", received, 0.4));
    BOOST_TEST((result.ending == Ending::time_limit));
    BOOST_TEST(result.wall_s < 5);
    BOOST_TEST(!received.empty());
}

BOOST_AUTO_TEST_CASE(exception_of_the_reader_ends_the_program) {
    const TemporaryDirectory directory;
    auto command = shell(directory, "echo $$ >leader; echo a >pipe; sleep 60");
    command.stream_name = "pipe";
    command.on_stream = [](std::string_view) { throw std::logic_error("enough"); };
    BOOST_CHECK_THROW((void)process::run(command), std::logic_error);
    BOOST_TEST(is_gone(directory.path() / "leader"));
}

BOOST_AUTO_TEST_CASE(signals_and_files_of_ours_are_not_inherited) {
    const TemporaryDirectory directory;
    const std::ofstream ours(directory.path() / "ours");
    std::signal(SIGPIPE, SIG_IGN);
    sigset_t blocked, before;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &blocked, &before);
    const auto result = process::run(
        shell(directory, "grep SigBlk /proc/self/status; ls /proc/self/fd | wc -l; kill -PIPE $$"));
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    std::signal(SIGPIPE, SIG_DFL);
    BOOST_TEST(result.status == SIGPIPE);
    // Standard input, output, error and the listing's own.
    BOOST_TEST(process::tail(result.stdout_file, 3) == "SigBlk:\t0000000000000000\n4");
}

BOOST_AUTO_TEST_CASE(program_not_on_path) {
    const TemporaryDirectory directory;
    process::Command command;
    command.argv = {"crossgrain-no-such-program"};
    command.directory = directory.path();
    command.time_limit = 1;
    BOOST_CHECK_EXCEPTION((void)process::run(command), std::system_error,
                          [](const auto& error) { return error.code().value() == ENOENT; });
    BOOST_TEST(!process::find_program("crossgrain-no-such-program"));
    BOOST_CHECK_EXCEPTION(
        (void)process::ask({.argv = {"crossgrain-no-such-program", "-h"}, .time_limit = 1}),
        std::system_error, [](const auto& error) { return error.code().value() == ENOENT; });
}

BOOST_AUTO_TEST_CASE(bad_commands_are_refused) {
    const TemporaryDirectory directory;
    BOOST_CHECK_THROW((void)process::run(shell(directory, "true", 0)), std::invalid_argument);
    process::Command empty;
    empty.time_limit = 1;
    BOOST_CHECK_THROW((void)process::run(empty), std::invalid_argument);
    auto nowhere = shell(directory, "true");
    nowhere.directory = directory.path() / "missing";
    BOOST_CHECK_THROW((void)process::run(nowhere), std::system_error);
}

BOOST_AUTO_TEST_CASE(programs_are_found) {
    const auto shell_path = process::find_program("sh");
    BOOST_TEST_REQUIRE(shell_path.has_value());
    BOOST_TEST(shell_path->is_absolute());
    BOOST_TEST((process::find_program(shell_path->string()) == shell_path));
    BOOST_TEST(!process::find_program("/etc/passwd"));
}

BOOST_AUTO_TEST_CASE(answer_of_a_program) {
    const auto ask = [](const std::string& script, double time_limit) {
        return process::ask({.argv = {"sh", "-c", script}, .time_limit = time_limit});
    };
    const auto answer = ask("echo out; echo err >&2; exit 1", 5);
    BOOST_TEST(answer.out == "out\n");
    BOOST_TEST(answer.err == "err\n");
    BOOST_TEST(answer.ended == "exit status 1");
    BOOST_TEST(ask("kill -SEGV $$", 5).ended == "killed by signal 11");
    BOOST_TEST((ask("sleep 60", 0.2).ending == Ending::time_limit));
    const auto flood = ask("yes", 20);
    BOOST_TEST((flood.ending == Ending::too_much_output));
    BOOST_TEST(flood.out.size() == process::longest_answer);
}

BOOST_AUTO_TEST_CASE(tail_of_a_file) {
    const TemporaryDirectory directory;
    const auto file = directory.path() / "log";
    BOOST_TEST(process::tail(file, 3).empty());
    std::ofstream(file) << "one\ntwo\nthree\n";
    BOOST_TEST(process::tail(file, 0).empty());
    BOOST_TEST(process::tail(file, 2) == "two\nthree");
    BOOST_TEST(process::tail(file, 3) == "one\ntwo\nthree");
    BOOST_TEST(process::tail(file, 9) == "one\ntwo\nthree");
    BOOST_TEST(process::read_text(file, 4) == "ree\n");
}
