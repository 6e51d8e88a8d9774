// The one list of observables. To add one, add a line in the file of its model.
#pragma once

#include "cases/catalog/case.hpp"
#include "cases/toml/keys.hpp"

#include <string>
#include <vector>

namespace crossgrain::observables {

/// An observable as `crossgrain observables` lists it.
struct ObservableText {
    std::string name, model, measures;
    std::vector<toml_input::Key> options;
};

[[nodiscard]] std::vector<ObservableText> observable_texts();

/// Folders whose sources decide what a case measures, e.g. "cases/measure/bed"; sorted. Throws
/// CaseError for an unknown observable.
[[nodiscard]] std::vector<std::string> source_folders(const catalog::Case& the_case);

/// Builds every estimator of every variant once, so that an unknown name or option, or a scene that
/// an observable cannot measure, is found before any run. Throws CaseError.
void check_observables(const catalog::Case& the_case);

}  // namespace crossgrain::observables
