// The [scene] table of a case file -> Scene. All keys are documented in cases/catalog/README.md.
#pragma once

#include "cases/scene/scene.hpp"
#include "cases/toml/keyed_table.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace crossgrain::scene {

/// What distinguishes one run's scene from its siblings of the same table.
struct SceneSelection {
    std::string name;           ///< becomes Scene::name
    std::size_t rung = 0;       ///< which of the listed time steps
    std::uint64_t seed = 1;     ///< of the initial state
    std::string readings = {};  ///< directory of the shipped readings of the models' rules
};

/// The keys of [scene] of a case of grains.
[[nodiscard]] const toml_input::TableKeys& scene_keys();

/// Number of time steps listed in `dt` or `steps_per_contact_time` (the rungs of a ladder), >= 1.
[[nodiscard]] std::size_t ladder_size(const toml_input::TomlTable& scene);

/// Reads, checks and resolves the table, and generates the initial state.
/// Throws CaseError for anything unknown, missing, of the wrong type, out of range or
/// contradictory.
[[nodiscard]] Scene read_scene(const toml_input::TomlTable& scene, const SceneSelection& selection);

}  // namespace crossgrain::scene
