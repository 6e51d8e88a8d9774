// The [scene.contact.friction] table of a case file -> Friction.
#pragma once

#include "cases/scene/friction.hpp"
#include "cases/toml/keyed_table.hpp"

namespace crossgrain::scene {

[[nodiscard]] const toml_input::TableKeys& friction_keys();

/// `normal_stiffness`: of the contact, for `stiffness_ratio`. Throws CaseError.
[[nodiscard]] Friction read_friction(const toml_input::KeyedTable& friction,
                                     double normal_stiffness);

}  // namespace crossgrain::scene
