// The one explicit catalogue of codes, observables and oracles. To add one, add a line here.
#pragma once

#include "adapters/code.hpp"
#include "cases/catalog/case.hpp"
#include "cases/measure/estimator.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::app {

/// All codes, in the order in which reports show them.
[[nodiscard]] const std::vector<std::unique_ptr<adapters::Code>>& codes();

/// Those named, or all if none is; throws CaseError with the nearest name.
[[nodiscard]] std::vector<const adapters::Code*>
select_codes(const std::vector<std::string>& names);

struct ObservableEntry {
    std::string name;
    std::string measures;              ///< measurements and series it yields, in words
    std::vector<std::string> options;  ///< of [[observable]] in a case file
    std::function<std::unique_ptr<measure::Estimator>(const scene::Scene&,
                                                      const catalog::ObservableRequest&)>
        make;
};

[[nodiscard]] const std::vector<ObservableEntry>& observables();

/// Builds the estimators a case asks for. Throws CaseError for an unknown observable or option.
[[nodiscard]] std::vector<std::unique_ptr<measure::Estimator>>
make_estimators(const catalog::Case& the_case, const scene::Scene& scene);

/// Checks the names of observables and their options. Throws CaseError.
void check_observables(const catalog::Case& the_case);

/// Checks the names of observables, options and codes, so that a typing error is found before any
/// run. Throws CaseError.
void check_names(const catalog::Case& the_case);

/// The exact value for a scene, e.g. "analytic:restitution". Nothing if the name is not known or
/// the closed form does not hold for this scene.
[[nodiscard]] std::optional<double> exact_value(const std::string& name, const scene::Scene& scene);
[[nodiscard]] std::vector<std::string> oracle_names();

}  // namespace crossgrain::app
