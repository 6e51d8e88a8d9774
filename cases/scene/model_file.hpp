// The [scene] tables of the models other than grains. All keys: cases/catalog/README.md.
#pragma once

#include "cases/scene/hopper_automaton.hpp"
#include "cases/scene/lattice_gas.hpp"
#include "cases/scene/scene_file.hpp"
#include "cases/scene/synthetic_signal.hpp"
#include "cases/toml/keyed_table.hpp"

namespace crossgrain::scene {

[[nodiscard]] const toml_input::TableKeys& lattice_gas_keys();
[[nodiscard]] const toml_input::TableKeys& hopper_automaton_keys();
[[nodiscard]] const toml_input::TableKeys& synthetic_signal_keys();

// Each reads, checks and resolves the table; throws CaseError for anything unknown, missing, of the
// wrong type, out of range or contradictory.
[[nodiscard]] LatticeGas read_lattice_gas(const toml_input::TomlTable& scene,
                                          const SceneSelection& selection);
[[nodiscard]] HopperAutomaton read_hopper_automaton(const toml_input::TomlTable& scene,
                                                    const SceneSelection& selection);
[[nodiscard]] SyntheticSignal read_synthetic_signal(const toml_input::TomlTable& scene,
                                                    const SceneSelection& selection);

}  // namespace crossgrain::scene
