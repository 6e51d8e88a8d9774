// Where crossgrain-guard is, the program that every foreign program runs under.
#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace crossgrain::adapters::process {

/// Starts the guard with these arguments (guard/protocol.hpp) and one end of a socket, so that no
/// signal but SIGKILL ends it before its work is done. Throws std::system_error.
[[nodiscard]] pid_t start_guard(int socket, std::vector<std::string> arguments,
                                const std::vector<std::string>& environment);

}  // namespace crossgrain::adapters::process
