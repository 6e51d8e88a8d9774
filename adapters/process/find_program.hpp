// Is a program on this machine?
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace crossgrain::adapters::process {

/// Full path of an executable on PATH, or of `name` itself when it contains a slash; or nothing.
[[nodiscard]] std::optional<std::filesystem::path> find_program(const std::string& name);

}  // namespace crossgrain::adapters::process
