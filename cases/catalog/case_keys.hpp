// The keys of a case file, beside those of its scene, checks, fits and variants.
#pragma once

#include "cases/toml/keys.hpp"

#include <string>
#include <vector>

namespace crossgrain::catalog {

/// A model of case files, and the keys of its [scene].
struct Model {
    std::string name;
    toml_input::KeysOf scene;
};
/// The first one is that of files that name none.
[[nodiscard]] const std::vector<Model>& models();

/// Of the file, of [quick] and of [chart], which are laid over it.
[[nodiscard]] const toml_input::TableKeys& case_keys();
[[nodiscard]] const toml_input::TableKeys& quick_keys();
[[nodiscard]] const toml_input::TableKeys& chart_keys();
/// Of the file with its [chart] laid over it.
[[nodiscard]] const toml_input::TableKeys& charted_case_keys();
/// Of [[observable]]: its name, and the options of the observable of that name.
[[nodiscard]] const toml_input::TableKeys& observable_keys();

}  // namespace crossgrain::catalog
