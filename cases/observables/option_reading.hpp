// From the options of a case file to those of an estimator, by the estimator's declaration of them
// (cases/measure/options.hpp).
#pragma once

#include "cases/catalog/case.hpp"
#include "cases/measure/options.hpp"
#include "cases/toml/keys.hpp"

#include <string>
#include <vector>

namespace crossgrain::observables {

/// Sets what the request gives and leaves the rest. Throws CaseError, with the option's place in
/// `file`, for one that is not declared, of the wrong type, or out of its range.
void read_options(const std::string& file, const catalog::ObservableRequest& request,
                  const measure::OptionKeys& keys);

/// The same declaration as keys of a table, for its schema. An option is required if its default is
/// out of its range.
[[nodiscard]] std::vector<toml_input::Key> table_keys(const measure::OptionKeys& keys);

}  // namespace crossgrain::observables
