// The variants of a case: its written [[variant]] tables, crossed with its [sweep].
#pragma once

#include "cases/catalog/case.hpp"
#include "cases/catalog/sweep_file.hpp"
#include "cases/toml/keyed_table.hpp"

#include <vector>

namespace crossgrain::catalog {

[[nodiscard]] const toml_input::TableKeys& variant_keys();

/// The [[variant]] tables; one without a name if there are none. Throws CaseError.
[[nodiscard]] std::vector<Variant> read_written_variants(const toml_input::KeyedTable& t);

/// Every point of the sweep in every written variant that is not limited to others, the sweep
/// changing slower. Throws CaseError for a limit that is no point of the sweep.
[[nodiscard]] std::vector<Variant> cross(const std::string& file, const Sweep& sweep,
                                         const std::vector<Variant>& written);

/// A check that names a variant which is not there would never be asked: throws CaseError. (The
/// quick suite may do without some of the variants that the case has.)
void check_variant_names(const Case& the_case);

}  // namespace crossgrain::catalog
