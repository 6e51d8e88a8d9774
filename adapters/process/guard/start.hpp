// Turning a new process into the program that a guard is to start.
#pragma once

#include "adapters/process/guard/protocol.hpp"

#include <variant>

#include <sys/resource.h>
#include <sys/types.h>

namespace crossgrain::adapters::process::guard {

struct Order {
    const char* program = nullptr;  ///< absolute path
    const char* directory = nullptr;
    const char* stdout_file = nullptr;
    const char* stderr_file = nullptr;
    rlim_t largest_file = 0;  ///< bytes that any file it writes may have
    char** argv = nullptr;
};

struct StartFailure {
    Step step = Step::start;
    int error = 0;  ///< errno
};

/// Starts the program: in its directory, as the leader of a new group, reading /dev/null, with
/// default signal handlers, no signal blocked, no core dump, and killed when this process ends.
/// Returns when it runs, or why it does not.
[[nodiscard]] std::variant<pid_t, StartFailure> start(const Order& order);

}  // namespace crossgrain::adapters::process::guard
