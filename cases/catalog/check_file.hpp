// The [[check]] tables of a case file.
#pragma once

#include "cases/catalog/case.hpp"
#include "cases/toml/keyed_table.hpp"

#include <vector>

namespace crossgrain::catalog {

[[nodiscard]] const toml_input::TableKeys& check_keys();

/// Throws CaseError, also for a limit without a reason.
[[nodiscard]] std::vector<Check> read_checks(const toml_input::KeyedTable& t);

}  // namespace crossgrain::catalog
