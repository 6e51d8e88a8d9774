// The [scene.plates] table of a case file -> Plates.
#pragma once

#include "cases/scene/scene.hpp"
#include "cases/toml/keyed_table.hpp"

namespace crossgrain::scene {

[[nodiscard]] const toml_input::TableKeys& plates_keys();

/// `contact_stiffness`: of plates that do not say theirs, > 0. Throws CaseError.
[[nodiscard]] Plates read_plates(const toml_input::KeyedTable& plates, double contact_stiffness);

}  // namespace crossgrain::scene
