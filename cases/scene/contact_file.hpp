// The [scene.contact] table of a case file -> ContactLaw, with its [scene.contact.friction].
#pragma once

#include "cases/scene/scene.hpp"
#include "cases/toml/toml_table.hpp"

namespace crossgrain::scene {

/// `mass`: of a grain (of grains that differ the nominal one), > 0; restitution and contact time
/// are those of two such grains. Throws CaseError.
[[nodiscard]] ContactLaw read_contact(const toml_input::TomlTable& contact, double mass);

}  // namespace crossgrain::scene
