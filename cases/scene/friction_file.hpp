// The [scene.contact.friction] table of a case file -> Friction.
#pragma once

#include "cases/scene/friction.hpp"
#include "cases/toml/toml_table.hpp"

namespace crossgrain::scene {

/// `normal_stiffness`: of the contact, for `stiffness_ratio`. Throws CaseError.
[[nodiscard]] Friction read_friction(const toml_input::TomlTable& friction,
                                     double normal_stiffness);

}  // namespace crossgrain::scene
