#include "adapters/process/process.hpp"

#include "adapters/process/child.hpp"
#include "adapters/process/find_program.hpp"
#include "adapters/process/stream_pipe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>

#include <unistd.h>

namespace crossgrain::adapters::process {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

namespace {

// How late the end of a program, its time limit or a stop request may be noticed.
constexpr int turn_milliseconds = 5;
constexpr auto grace = std::chrono::milliseconds(500);

/// The inherited environment with `extra` added; a name in `extra` replaces the inherited one.
std::vector<std::string> environment_with(const std::vector<std::string>& extra) {
    std::vector<std::string> result = extra;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text(*entry);
        const std::string name = text.substr(0, text.find('=') + 1);
        bool replaced = false;
        for (const auto& added : extra)
            replaced = replaced || added.starts_with(name);
        if (!replaced) result.push_back(text);
    }
    return result;
}

constexpr const char* temporary_name = "tmp";

/// What the command adds to the environment. Whatever the program leaves in the directory for
/// temporary files goes with its run.
std::vector<std::string> additions_of(const Command& command, const fs::path& directory) {
    std::vector<std::string> added = command.extra_environment;
    for (const std::string name : {"TMPDIR=", "TMP=", "TEMP="}) {
        const bool given = std::ranges::any_of(
            command.extra_environment, [&](const auto& text) { return text.starts_with(name); });
        if (!given) added.push_back(name + (directory / temporary_name).string());
    }
    return added;
}

ChildSetup setup_of(const Command& command) {
    if (command.argv.empty() || !(command.time_limit > 0)) {
        throw std::invalid_argument("a command needs a program and a time limit > 0");
    }
    const auto program = find_program(command.argv.front());
    if (!program) {
        throw std::system_error(ENOENT, std::generic_category(), command.argv.front());
    }
    const fs::path directory = fs::absolute(command.directory);
    if (!fs::is_directory(directory)) {
        throw std::system_error(ENOTDIR, std::generic_category(), directory.string());
    }
    fs::create_directory(directory / temporary_name);
    return {.program = *program,
            .argv = command.argv,
            .directory = directory,
            .environment = environment_with(additions_of(command, directory)),
            .stdout_file = directory / "stdout.txt",
            .stderr_file = directory / "stderr.txt",
            .largest_file = command.largest_file};
}

std::string size_text(std::uint64_t bytes) {
    constexpr std::array units{"bytes", "KiB", "MiB", "GiB"};
    std::size_t unit = 0;
    for (; bytes % 1024 == 0 && bytes > 0 && unit + 1 < units.size(); ++unit)
        bytes /= 1024;
    return fmt::format("{} {}", bytes, units[unit]);
}

/// One run, from its start on.
class Supervisor {
  public:
    explicit Supervisor(const Command& command)
        : command_(command), setup_(setup_of(command)), stream_(open_stream()), child_(setup_),
          start_(Clock::now()), limit_(start_ + seconds_of(command.time_limit)) {}

    Result run() {
        Ending ending = Ending::exited;
        while (!child_.has_ended()) {
            if (command_.stop.stop_requested()) {
                ending = Ending::stopped;
            } else if (Clock::now() >= limit_) {
                ending = Ending::time_limit;
            } else if (has_filled_a_log()) {
                // Of no use any more, even if it goes on in spite of its failing writes.
                ending = Ending::too_much_output;
            }
            if (ending != Ending::exited) {
                end_group();
                break;
            }
            wait_for_news();
            deliver();
        }
        // Nobody writes any more, so that this comes to an end.
        while (ending == Ending::exited && deliver()) {
            if (Clock::now() >= limit_) ending = Ending::time_limit;
        }
        return result(ending);
    }

  private:
    static Clock::duration seconds_of(double seconds) {
        // A century is as good as for ever, and does not overflow.
        constexpr double century = 3.2e9;
        const std::chrono::duration<double> wanted(seconds < century ? seconds : century);
        return std::chrono::duration_cast<Clock::duration>(wanted);
    }

    std::optional<StreamPipe> open_stream() const {
        if (command_.stream_name.empty()) return std::nullopt;
        return std::optional<StreamPipe>(std::in_place, setup_.directory / command_.stream_name);
    }

    void wait_for_news() const {
        if (stream_) {
            stream_->wait(turn_milliseconds);
        } else {
            std::this_thread::sleep_for(std::chrono::milliseconds(turn_milliseconds));
        }
    }

    /// Passes on what the pipe holds now; false if that is nothing.
    bool deliver() {
        if (!stream_) return false;
        const std::string_view bytes = stream_->read();
        if (bytes.empty()) return false;
        if (command_.on_stream) command_.on_stream(bytes);
        return true;
    }

    [[nodiscard]] bool has_filled_a_log() const {
        return std::ranges::any_of(std::array{&setup_.stdout_file, &setup_.stderr_file},
                                   [&](const fs::path* log) {
                                       std::error_code error;
                                       const auto size = fs::file_size(*log, error);
                                       return !error && size > command_.largest_log;
                                   });
    }

    /// SIGTERM, then time to end in an orderly way. The pipe is emptied meanwhile: a program that
    /// waits for us to read could not end.
    void end_group() {
        child_.ask_to_end();
        const auto until = Clock::now() + grace;
        while (!child_.has_ended() && Clock::now() < until) {
            wait_for_news();
            if (stream_) (void)stream_->read();
        }
    }

    Result result(Ending ending) {
        const Reaped reaped = child_.reap();
        const bool filled_a_log = has_filled_a_log();
        // A shell tells of it by an exit status.
        constexpr int of_a_shell = 128;
        const bool filled_a_file =
            reaped.status == (reaped.signalled ? SIGXFSZ : of_a_shell + SIGXFSZ);
        if (ending == Ending::exited) {
            if (reaped.signalled) ending = Ending::signalled;
            if (filled_a_log || filled_a_file) ending = Ending::too_much_output;
        }
        std::error_code ignored;  // goes with the directory then
        fs::remove_all(setup_.directory / temporary_name, ignored);
        return {.ending = ending,
                .status = reaped.status,
                .cpu_s = reaped.cpu_s,
                .wall_s = std::chrono::duration<double>(Clock::now() - start_).count(),
                .stdout_file = setup_.stdout_file,
                .stderr_file = setup_.stderr_file,
                .exceeded = filled_a_log ? command_.largest_log : command_.largest_file};
    }

    const Command& command_;
    ChildSetup setup_;
    std::optional<StreamPipe> stream_;  // open before the child starts
    Child child_;
    Clock::time_point start_;
    Clock::time_point limit_;
};

}  // namespace

Result run(const Command& command) {
    return Supervisor(command).run();
}

std::string describe(const Result& result, double time_limit) {
    switch (result.ending) {
    case Ending::exited:
        return fmt::format("exit status {}", result.status);
    case Ending::signalled:
        return fmt::format("killed by signal {}", result.status);
    case Ending::time_limit:
        return fmt::format("killed at the time limit of {:g} s", time_limit);
    case Ending::stopped:
        return "stopped";
    case Ending::too_much_output:
        return fmt::format("ended because it wrote more than {} to its standard output or a file",
                           size_text(result.exceeded));
    }
    return {};
}

}  // namespace crossgrain::adapters::process
