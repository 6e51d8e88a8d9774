// Starting a program that neither Ctrl-C nor a closed terminal reaches.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace crossgrain::adapters::process {

struct SessionStart {
    std::filesystem::path program;         ///< absolute
    std::vector<std::string> argv;         ///< with argv[0]
    std::vector<std::string> environment;  ///< complete, "NAME=value"
    std::optional<int> inherited;          ///< a descriptor that it gets as number 3
    bool block_signals = false;            ///< whether it starts with all signals blocked
};

/// Starts a program in a session of its own, with default signal handlers, /dev/null as its
/// standard files, and none of ours but `inherited`. Throws std::system_error.
[[nodiscard]] pid_t start_in_own_session(const SessionStart& start);

}  // namespace crossgrain::adapters::process
