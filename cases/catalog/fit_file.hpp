// Reads the [[fit]] tables of a case file.
#pragma once

#include "cases/catalog/case.hpp"
#include "cases/toml/keyed_table.hpp"

namespace crossgrain::catalog {

[[nodiscard]] const toml_input::TableKeys& fit_keys();

/// Throws CaseError with place and expectation for a bad table.
[[nodiscard]] std::vector<Fit> read_fits(const toml_input::KeyedTable& t);

}  // namespace crossgrain::catalog
