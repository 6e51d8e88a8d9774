// The [scene.initial] table of a case file -> recipe of an initial state.
#pragma once

#include "cases/scene/initial_state.hpp"
#include "cases/toml/keyed_table.hpp"

namespace crossgrain::scene {

[[nodiscard]] const toml_input::TableKeys& initial_keys();

/// Throws CaseError.
[[nodiscard]] InitialStateRecipe read_initial_state(const toml_input::KeyedTable& initial);

}  // namespace crossgrain::scene
