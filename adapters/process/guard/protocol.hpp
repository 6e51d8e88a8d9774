// What a guard (guard.cpp) and the program that started it say to each other, over a socket whose
// every message is one packet.
#pragma once

#include <cstdint>

namespace crossgrain::adapters::process::guard {

/// Both come from one build; what is left over from another must not be misunderstood.
inline constexpr const char* protocol = "1";
/// The guard's end of the socket.
inline constexpr int socket_number = 3;

/// The guard's arguments; those of the program, from its own name on, come last.
enum Argument : int {
    argument_protocol = 1,
    argument_program,  ///< absolute path
    argument_directory,
    argument_stdout,
    argument_stderr,
    argument_largest_file,  ///< bytes
    argument_argv
};

/// To the guard: ask the program to end. That the socket is closed means: end everybody.
enum class Request : char { end = 'e', kill = 'k' };

/// Where the start of a program may fail.
enum class Step : std::int32_t { start, enter_directory, open_stdout, open_stderr, execute };

/// From the guard: `started` or `failed` once, and `ended` when nobody is left.
struct Report {
    enum class Kind : std::int32_t { started, failed, ended } kind = Kind::started;
    Step step = Step::start;     ///< failed: where
    std::int32_t number = 0;     ///< started: the program; failed: errno; ended: status or signal
    std::int32_t signalled = 0;  ///< ended: whether by a signal
    double cpu_s = 0;            ///< ended: user + system of all
};

}  // namespace crossgrain::adapters::process::guard
