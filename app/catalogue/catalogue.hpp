// The one explicit catalogue of codes, observables and oracles. To add one, add a line here.
#pragma once

#include "adapters/code.hpp"
#include "cases/catalog/case.hpp"
#include "cases/scene/any_scene.hpp"

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

/// An observable as `crossgrain observables` lists it.
struct ObservableText {
    std::string name, model, measures;
    std::vector<std::string> options;
};

[[nodiscard]] std::vector<ObservableText> observable_texts();

/// Builds every estimator of every variant once, so that an unknown name or option, or a scene that
/// an observable cannot measure, is found before any run. Throws CaseError.
void check_observables(const catalog::Case& the_case);

/// Checks the names of observables, options and codes, so that a typing error is found before any
/// run. Throws CaseError.
void check_names(const catalog::Case& the_case);

/// The exact value for a scene, e.g. "analytic:restitution". Nothing if the name is not known or
/// the closed form does not hold for this scene.
[[nodiscard]] std::optional<double> exact_value(const std::string& name,
                                                const scene::AnyScene& scene);
[[nodiscard]] std::vector<std::string> oracle_names();

}  // namespace crossgrain::app
