// Starts a foreign program and never trusts it: argv only (no shell), a private working directory,
// its own process group, a wall-clock limit after which the whole group is killed, stdout and
// stderr kept in files, and an optional stream (a named pipe in the directory) that is read while
// the program runs, so that no trajectory needs to be stored.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace crossgrain::adapters::process {

struct Command {
    std::vector<std::string> argv;     ///< argv[0] is looked up on PATH
    std::filesystem::path directory;   ///< working directory; must exist
    std::vector<std::string> extra_environment;  ///< "NAME=value", added to the inherited one
    double time_limit = 0;             ///< wall seconds, > 0
    std::stop_token stop;
    /// Name of a pipe to create in the directory before the start; empty for none.
    std::string stream_name;
    /// Called with each chunk read from the pipe. An exception ends the program and is rethrown.
    std::function<void(std::string_view)> on_stream;
};

enum class Ending { exited, signalled, time_limit, stopped };

struct Result {
    Ending ending = Ending::exited;
    int status = 0;      ///< exit status or signal number
    double cpu_s = 0;    ///< user + system of the program and its reaped children
    double wall_s = 0;
    std::filesystem::path stdout_file, stderr_file;  ///< <directory>/stdout.txt, stderr.txt
};

/// Full path of a program on PATH, or nothing.
[[nodiscard]] std::optional<std::filesystem::path> find_program(const std::string& name);

/// Runs to the end, the limit or the stop request; kills the whole process group in the last two
/// cases, and whenever the program itself is gone. Throws std::system_error if it cannot be
/// started.
[[nodiscard]] Result run(const Command& command);

/// "exit status 1", "killed by signal 11", "killed at the time limit of 60 s", "stopped".
[[nodiscard]] std::string describe(const Result& result, double time_limit);

/// At most `lines` last lines of a text file; empty if it cannot be read.
[[nodiscard]] std::string tail(const std::filesystem::path& file, std::size_t lines);

}  // namespace crossgrain::adapters::process
