// A run of any of the models. What they share is only what the harness itself needs.
#pragma once

#include "cases/scene/frame.hpp"
#include "cases/scene/gas_frame.hpp"
#include "cases/scene/hopper_automaton.hpp"
#include "cases/scene/hopper_frame.hpp"
#include "cases/scene/lattice_gas.hpp"
#include "cases/scene/scene.hpp"
#include "cases/scene/synthetic_signal.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace crossgrain::scene {

/// Discs with contact forces (distinct elements), the lattice gas, the hopper automaton, or a
/// signal that calibrates estimators.
using AnyScene = std::variant<Scene, LatticeGas, HopperAutomaton, SyntheticSignal>;

/// The kind of frame a scene yields.
template <class SceneT>
struct FrameOf;
template <>
struct FrameOf<Scene> {
    using type = Frame;
};
template <>
struct FrameOf<LatticeGas> {
    using type = GasFrame;
};
template <>
struct FrameOf<SyntheticSignal> {
    using type = GasFrame;
};
template <>
struct FrameOf<HopperAutomaton> {
    using type = HopperFrame;
};

/// Name of the model in case files: "grains", "lattice-gas", "hopper-automaton",
/// "synthetic-signal".
[[nodiscard]] std::string model_of(const AnyScene& scene);
[[nodiscard]] const std::string& name_of(const AnyScene& scene);
[[nodiscard]] std::uint64_t seed_of(const AnyScene& scene);
/// dt of a scene of grains, 0 for the models on lattices (they have no ladder of time steps).
[[nodiscard]] double time_step_of(const AnyScene& scene);
/// What the run does, for its cost: particle-steps, site updates, or grain moves expected at most.
struct Work {
    double amount = 0;
    std::string unit;
};
[[nodiscard]] Work work_of(const AnyScene& scene);
/// Bytes that the scene itself takes in memory: all runs of a case are planned before any starts.
[[nodiscard]] double bytes_of(const AnyScene& scene);
/// What a user should know before the run: one line each, e.g. an angle beyond which a number loses
/// its meaning.
[[nodiscard]] std::vector<std::string> warnings_of(const AnyScene& scene);
/// Everything that decides the run's numbers, name excluded.
[[nodiscard]] nlohmann::json identity_json(const AnyScene& scene);
/// The few numbers and names that a reader of a report wants.
[[nodiscard]] nlohmann::json settings_json(const AnyScene& scene);

}  // namespace crossgrain::scene
