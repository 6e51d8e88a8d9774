// Reads the [[fit]] tables of a case file.
#pragma once

#include "cases/catalog/case.hpp"
#include "cases/toml/toml_table.hpp"

namespace crossgrain::catalog {

/// Throws CaseError for a table that makes no sense.
[[nodiscard]] std::vector<Fit> read_fits(const toml_input::TomlTable& t);

}  // namespace crossgrain::catalog
