// Nobody is left behind: programs that try to outlive us, and all the ways in which we may end.
#include "adapters/process/detached.hpp"
#include "adapters/process/process.hpp"
#include "tests/support/processes.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;
namespace process = crossgrain::adapters::process;
using crossgrain::tests::TemporaryDirectory;
using process::Ending;

namespace {

/// A shell script and, in its environment, a mark that all its descendants inherit.
class Marked {
  public:
    [[nodiscard]] process::Command command(const std::string& script,
                                           double time_limit = 20) const {
        return {.argv = {"sh", "-c", script},
                .directory = directory_.path(),
                .extra_environment = {mark_},
                .time_limit = time_limit};
    }
    [[nodiscard]] const std::string& mark() const { return mark_; }
    [[nodiscard]] fs::path file(const std::string& name) const { return directory_.path() / name; }
    void wait_for(const std::string& name) const {
        for (int turn = 0; turn < 1000 && !fs::exists(file(name)); ++turn)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        BOOST_TEST_REQUIRE(fs::exists(file(name)));
    }

  private:
    TemporaryDirectory directory_;
    std::string mark_ = "CROSSGRAIN_TEST_MARK=" + directory_.path().string();
};

/// Three that leave the group or the family, none of whom hears SIGTERM; "ready" when all are
/// there.
const std::string deserters =
    "trap '' TERM HUP\n"
    "setsid sh -c 'touch a; sleep 60; true' &\n"
    "(setsid sh -c 'sh -c \"touch b; sleep 60; true\" & exec true' &)\n"
    "(setsid sh -c '(touch c; sleep 60; true) & touch d; sleep 60; true' &)\n"
    "while [ ! -e a -o ! -e b -o ! -e c -o ! -e d ]; do sleep 0.01; done; touch ready\n";

/// Runs the command in another process, as a crossgrain that can be killed.
pid_t run_elsewhere(const process::Command& command) {
    const pid_t other = fork();
    if (other == 0) {
        // Not those of the test's framework.
        for (const int signal_number : {SIGTERM, SIGSEGV, SIGPIPE, SIGHUP})
            std::signal(signal_number, SIG_DFL);
        try {
            (void)process::run(command);
        } catch (const std::exception&) {
        }
        _exit(0);
    }
    BOOST_TEST_REQUIRE(other > 0);
    return other;
}

std::size_t open_files() {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()));
}

}  // namespace

BOOST_AUTO_TEST_CASE(marked_processes_are_seen) {
    const Marked marked;
    const pid_t other = run_elsewhere(marked.command("touch ready; sleep 60"));
    marked.wait_for("ready");
    BOOST_TEST(!crossgrain::tests::all_gone(marked.mark(), 0));
    kill(other, SIGKILL);
    waitpid(other, nullptr, 0);
}

BOOST_AUTO_TEST_CASE(deserters_are_killed_at_the_end) {
    const Marked marked;
    const auto result = process::run(marked.command(deserters + "exit 3"));
    BOOST_TEST(result.status == 3);
    BOOST_TEST(result.wall_s < 10);
    BOOST_TEST(crossgrain::tests::processes_with(marked.mark()).empty());
}

BOOST_AUTO_TEST_CASE(deserters_are_killed_at_the_time_limit) {
    const Marked marked;
    const auto result = process::run(marked.command(deserters + "sleep 60", 1));
    BOOST_TEST((result.ending == Ending::time_limit));
    BOOST_TEST(fs::exists(marked.file("ready")));
    BOOST_TEST(crossgrain::tests::processes_with(marked.mark()).empty());
}

BOOST_AUTO_TEST_CASE(everybody_is_killed_when_we_are) {
    for (const int signal : {SIGKILL, SIGTERM, SIGSEGV, SIGPIPE, SIGHUP}) {
        const Marked marked;
        const pid_t other = run_elsewhere(marked.command(deserters + "sleep 60"));
        marked.wait_for("ready");
        kill(other, signal);
        waitpid(other, nullptr, 0);
        BOOST_TEST(crossgrain::tests::all_gone(marked.mark()));
    }
}

BOOST_AUTO_TEST_CASE(nobody_starts_when_we_are_killed_early) {
    for (int delay_us = 0; delay_us < 6000; delay_us += 150) {
        const Marked marked;
        const pid_t other = run_elsewhere(marked.command("sleep 60"));
        std::this_thread::sleep_for(std::chrono::microseconds(delay_us));
        kill(other, SIGKILL);
        waitpid(other, nullptr, 0);
        BOOST_TEST(crossgrain::tests::all_gone(marked.mark()));
    }
}

BOOST_AUTO_TEST_CASE(a_guard_that_is_killed_is_noticed) {
    const Marked marked;
    // Its guard is the parent of the program.
    BOOST_CHECK_THROW((void)process::run(marked.command("sleep 0.2; kill -KILL $PPID; sleep 60")),
                      std::system_error);
    BOOST_TEST(crossgrain::tests::all_gone(marked.mark()));
}

BOOST_AUTO_TEST_CASE(cpu_time_counts_deserters) {
    const Marked marked;
    const auto result = process::run(marked.command(
        "(setsid sh -c 'i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done; touch done' &)\n"
        "while [ ! -e done ]; do sleep 0.01; done"));
    BOOST_TEST(result.cpu_s > 0.02);
}

BOOST_AUTO_TEST_CASE(output_without_end_is_stopped) {
    const Marked marked;
    auto command = marked.command("exec yes");
    command.largest_log = 1 << 20;
    const auto result = process::run(command);
    BOOST_TEST((result.ending == Ending::too_much_output));
    BOOST_TEST(result.wall_s < 10);
    BOOST_TEST(process::describe(result, 20) ==
               "ended because it wrote more than 1 MiB to its standard output or a file");
    command.argv.back() = "yes >&2";
    BOOST_TEST((process::run(command).ending == Ending::too_much_output));
    command.argv.back() = "head -c 1000000 /dev/zero; exit 4";
    BOOST_TEST(process::run(command).status == 4);
}

BOOST_AUTO_TEST_CASE(a_file_without_end_is_stopped) {
    const Marked marked;
    auto command = marked.command("exec yes >file");
    command.largest_file = 3 << 20;
    const auto result = process::run(command);
    BOOST_TEST((result.ending == Ending::too_much_output));
    BOOST_TEST(fs::file_size(marked.file("file")) == command.largest_file);
    BOOST_TEST(process::describe(result, 20) ==
               "ended because it wrote more than 3 MiB to its standard output or a file");
}

BOOST_AUTO_TEST_CASE(why_a_program_does_not_start) {
    const Marked marked;
    const auto reason = [&](const process::Command& command) -> std::string {
        try {
            (void)process::run(command);
        } catch (const std::system_error& error) {
            return error.what();
        }
        return "none";
    };
    const auto program = marked.file("program");
    const auto contains = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    auto command = marked.command("");
    command.argv = {program.string()};
    const auto write = [&](const std::string& text) {
        std::ofstream(program) << text;
        fs::permissions(program, fs::perms::owner_all);
    };
    write("#!/crossgrain/no/such/interpreter\n");
    BOOST_TEST(contains(reason(command), "its interpreter is missing: No such file"));
    write("no format that is known");
    BOOST_TEST(contains(reason(command), "cannot start " + program.string() + ": Exec format"));
    write("#!/bin/sh\nexit 0\n");
    BOOST_TEST(reason(command) == "none");
    fs::remove(marked.file("stdout.txt"));
    fs::create_directory(marked.file("stdout.txt"));
    BOOST_TEST(contains(reason(command), "cannot write " + marked.file("stdout.txt").string()));
}

BOOST_AUTO_TEST_CASE(temporary_files_go_with_the_run) {
    const Marked marked;
    const auto result = process::run(
        marked.command("echo left >$TMPDIR/left; mktemp; [ $TMP = $TMPDIR ] && echo $TMPDIR"));
    std::ifstream log(result.stdout_file);
    std::string made, place;
    log >> made >> place;
    BOOST_TEST(fs::path(made).parent_path() == place);
    BOOST_TEST(fs::path(place).parent_path() == marked.file("x").parent_path());
    BOOST_TEST(!fs::exists(place));
}

BOOST_AUTO_TEST_CASE(nothing_of_ours_leaks) {
    const Marked marked;
    (void)process::run(marked.command("true"));
    const auto before = open_files();
    for (int run = 0; run < 50; ++run) {
        auto command = marked.command("echo a >pipe");
        command.stream_name = "pipe" + std::to_string(run);
        (void)process::run(command);
        command.argv = {"/"};
        BOOST_CHECK_THROW((void)process::run(command), std::system_error);
        command.argv = {"sh"};
        command.stream_name = "no/such/directory";
        BOOST_CHECK_THROW((void)process::run(command), std::system_error);
    }
    BOOST_TEST(open_files() == before);
    // No zombie, no guard.
    BOOST_TEST(waitpid(-1, nullptr, WNOHANG) == -1);
    BOOST_TEST(errno == ECHILD);
}

BOOST_AUTO_TEST_CASE(many_at_once) {
    std::vector<std::jthread> threads;
    std::atomic<int> good = 0;
    for (int i = 0; i < 8; ++i) {
        threads.emplace_back([&good, i] {
            for (int run = 0; run < 10; ++run) {
                const Marked marked;
                const auto result = process::run(marked.command("exit " + std::to_string(i)));
                good += result.ending == Ending::exited && result.status == i ? 1 : 0;
            }
        });
    }
    threads.clear();
    BOOST_TEST(good == 80);
}

BOOST_AUTO_TEST_CASE(a_detached_program_goes_on) {
    const Marked marked;
    const auto file = marked.file("done").string();
    BOOST_TEST(process::start_detached("/bin/sh", {"-c", "sleep 2.5; touch " + file}));
    BOOST_TEST(!fs::exists(file));
    marked.wait_for("done");
    BOOST_TEST(!process::start_detached("/bin/sh", {"-c", "exit 3"}));
    BOOST_TEST(!process::start_detached("/no/such/program", {}));
}
