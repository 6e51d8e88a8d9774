// The states that the runs of a map were found in, over the sweep of a case or of the failure map
// it names.
#pragma once

#include "adapters/run/settings.hpp"
#include "adapters/run/store/store.hpp"
#include "reports/studies/stability/stability.hpp"

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::studies {

/// The cases of this call. Before anything is computed one that was named and cannot be tried out
/// is refused (CaseError); of all cases it is left out.
[[nodiscard]] std::vector<std::shared_ptr<const catalog::Case>>
cases_with_thresholds(const run::Settings& settings, const std::stop_token& stop);

/// The case whose sweep maps where this one fails: itself unless it names another, which may name
/// another for other keys. The first that has the most of the keys asked for.
[[nodiscard]] std::string map_of(const catalog::Case& the_case,
                                 const std::vector<std::string>& axes);

/// States over the parameters of the cases, in all codes that run them; kept in the store, so that
/// a map that was stopped goes on where it was.
[[nodiscard]] std::vector<StabilityReport>
stability_maps(const run::Settings& settings, store::Store& store, const std::stop_token& stop);

}  // namespace crossgrain::studies
