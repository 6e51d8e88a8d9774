// The [scene.contact] table of a case file -> ContactLaw, with its [scene.contact.friction].
#pragma once

#include "cases/scene/scene.hpp"
#include "cases/toml/keyed_table.hpp"

namespace crossgrain::scene {

[[nodiscard]] const toml_input::TableKeys& contact_keys();

/// `mass`: of a grain (of grains that differ the nominal one), > 0; restitution and contact time
/// are those of two such grains. Throws CaseError.
[[nodiscard]] ContactLaw read_contact(const toml_input::KeyedTable& contact, double mass);

}  // namespace crossgrain::scene
