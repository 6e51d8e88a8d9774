// What of our own sources a run depends on.
#pragma once

#include "adapters/registry/source_folder.hpp"

#include <set>
#include <span>
#include <string>
#include <vector>

namespace crossgrain::adapters {

/// The folders and all that they include, directly or through others. Throws std::invalid_argument
/// for a folder that is not in the table.
[[nodiscard]] std::set<std::string> with_needs(std::span<const SourceFolder> table,
                                               const std::vector<std::string>& folders);

/// SHA-256 over the sources of with_needs().
[[nodiscard]] std::string source_key(std::span<const SourceFolder> table,
                                     const std::vector<std::string>& folders);

/// The same of the sources that this program was built from.
[[nodiscard]] std::string source_key(const std::vector<std::string>& folders);
[[nodiscard]] std::span<const SourceFolder> built_sources();

}  // namespace crossgrain::adapters
