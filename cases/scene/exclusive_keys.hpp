// Keys of a table of which exactly one must be given.
#pragma once

#include "cases/toml/toml_table.hpp"

#include <string>
#include <vector>

namespace crossgrain::scene {

/// Says which of the keys is given. Throws CaseError when it is none or two of them.
[[nodiscard]] std::string exactly_one(const toml_input::TomlTable& t,
                                      const std::vector<std::string>& keys);

}  // namespace crossgrain::scene
