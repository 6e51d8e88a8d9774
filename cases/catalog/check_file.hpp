// The [[check]] tables of a case file.
#pragma once

#include "cases/catalog/case.hpp"
#include "cases/toml/toml_table.hpp"

#include <vector>

namespace crossgrain::catalog {

/// Throws CaseError, also for a limit without a reason.
[[nodiscard]] std::vector<Check> read_checks(const toml_input::TomlTable& t);

}  // namespace crossgrain::catalog
