// The [scene.initial] table of a case file -> recipe of an initial state.
#pragma once

#include "cases/scene/initial_state.hpp"
#include "cases/toml/toml_table.hpp"

namespace crossgrain::scene {

/// Throws CaseError.
[[nodiscard]] InitialStateRecipe read_initial_state(const toml_input::TomlTable& initial);

}  // namespace crossgrain::scene
