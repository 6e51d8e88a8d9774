// Starting a program that is the user's from then on, such as a browser.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace crossgrain::adapters::process {

/// Starts a program that may outlive us, without a guard and in a session of its own. False if it
/// cannot be started, or fails within two seconds.
[[nodiscard]] bool start_detached(const std::filesystem::path& program,
                                  std::vector<std::string> arguments);

}  // namespace crossgrain::adapters::process
