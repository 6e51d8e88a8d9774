// Is a program on this machine, and what does it say about itself?
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::adapters::process {

/// Full path of an executable on PATH, or of `name` itself when it contains a slash; or nothing.
[[nodiscard]] std::optional<std::filesystem::path> find_program(const std::string& name);

/// All that a short command, e.g. {"lmp", "-h"}, prints (stdout, then stderr), run in a directory
/// of its own that is removed afterwards. Nothing if it cannot be started or does not end within
/// `time_limit` (wall seconds). Its exit status is not looked at: some programs exit with 1 from
/// their own help.
[[nodiscard]] std::optional<std::string> output_of(const std::vector<std::string>& argv,
                                                   double time_limit);

}  // namespace crossgrain::adapters::process
