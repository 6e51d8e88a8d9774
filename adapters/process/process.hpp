// Starts a foreign program and never trusts it: argv only (no shell), a private working directory
// with a TMPDIR in it, a guard that ends whoever it brings along, a wall-clock limit, files of
// bounded size, stdout and stderr kept in files, and an optional stream (a named pipe in the
// directory) that is read while the program runs, so that no trajectory needs to be stored.
// Not Boost.Process: its group wait is unreliable (Boost 1.74) and it cannot read such a stream.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace crossgrain::adapters::process {

struct Command {
    std::vector<std::string> argv;    ///< argv[0] is looked up on PATH
    std::filesystem::path directory;  ///< working directory; must exist
    /// "NAME=value", added to the inherited one. Without a TMPDIR in it, that is a directory of the
    /// run, and goes when the program has ended.
    std::vector<std::string> extra_environment;
    double time_limit = 0;  ///< wall seconds, > 0
    std::stop_token stop;
    /// Name of a pipe to create in the directory before the start; empty for none.
    std::string stream_name;
    /// Called with each chunk read from the pipe. An exception ends the program and is rethrown.
    std::function<void(std::string_view)> on_stream;
    /// Bytes that its standard output and error may have, and any other file that it writes (MPI
    /// keeps shared memory in files: it must be larger than these).
    std::uint64_t largest_log = std::uint64_t{256} << 20, largest_file = std::uint64_t{1} << 30;
};

enum class Ending { exited, signalled, time_limit, stopped, too_much_output };

struct Result {
    Ending ending = Ending::exited;
    int status = 0;    ///< exit status or signal number
    double cpu_s = 0;  ///< user + system of the program and all its descendants
    double wall_s = 0;
    std::filesystem::path stdout_file, stderr_file;  ///< <directory>/stdout.txt, stderr.txt
    std::uint64_t exceeded = 0;                      ///< too_much_output: the limit, bytes
};

/// Runs to the end, a limit or the stop request. Whatever is left of the process group then is
/// asked to end (SIGTERM) and half a second later killed; when the program itself is gone, all its
/// descendants are killed at once, also those who left the group. So they are when this process is
/// killed. What the program had written to the stream before it ended is delivered completely.
/// Throws std::system_error if it cannot be started.
[[nodiscard]] Result run(const Command& command);

/// "exit status 1", "killed by signal 11", "killed at the time limit of 60 s", "stopped", "ended
/// because it wrote more than 256 MiB to its standard output or a file".
[[nodiscard]] std::string describe(const Result& result, double time_limit);

}  // namespace crossgrain::adapters::process
