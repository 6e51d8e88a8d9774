// Which shared libraries a program loads.
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::adapters::process {

/// The dynamic loader that an ELF executable names; nothing for other files and for those that are
/// linked statically. Throws std::system_error if the file cannot be read.
[[nodiscard]] std::optional<std::filesystem::path>
loader_of(const std::filesystem::path& executable);

/// What the loader says that it would load for an executable and for `modules`, which are loaded
/// later. Throws std::system_error with the loader's words if something is missing,
/// Interrupted on a stop request.
[[nodiscard]] std::vector<std::filesystem::path>
shared_libraries(const std::filesystem::path& loader, const std::filesystem::path& executable,
                 const std::vector<std::filesystem::path>& modules,
                 const std::vector<std::string>& extra_environment, const std::stop_token& stop);

}  // namespace crossgrain::adapters::process
