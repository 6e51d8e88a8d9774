// The models other than grains as JSON: canonical (to_json: every field that decides a number) and
// for readers (settings_json).
#pragma once

#include "cases/scene/hopper_automaton.hpp"
#include "cases/scene/lattice_gas.hpp"
#include "cases/scene/synthetic_signal.hpp"

#include <nlohmann/json_fwd.hpp>

namespace crossgrain::scene {

[[nodiscard]] nlohmann::json to_json(const LatticeGas& scene);
[[nodiscard]] nlohmann::json settings_json(const LatticeGas& scene);
[[nodiscard]] nlohmann::json to_json(const HopperAutomaton& scene);
[[nodiscard]] nlohmann::json settings_json(const HopperAutomaton& scene);
[[nodiscard]] nlohmann::json to_json(const SyntheticSignal& scene);
[[nodiscard]] nlohmann::json settings_json(const SyntheticSignal& scene);

}  // namespace crossgrain::scene
