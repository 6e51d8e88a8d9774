// What a code says of a scene, whatever the model.
#pragma once

#include "adapters/code.hpp"
#include "cases/scene/any_scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace crossgrain::run {

/// Whether the code runs scenes of this model at all.
[[nodiscard]] bool runs_model(const adapters::Code& code, const std::string& model);

/// Calls f(code, scene) with both in their own types. The code must run the scene's model.
template <class F>
decltype(auto) with_code(const adapters::Code& code, const scene::AnyScene& scene, F f) {
    return std::visit(
        [&](const auto& own) {
            using SceneT = std::decay_t<decltype(own)>;
            return f(dynamic_cast<const adapters::CodeFor<SceneT>&>(code), own);
        },
        scene);
}

[[nodiscard]] std::optional<std::string> cannot_express(const adapters::Code& code,
                                                        const scene::AnyScene& scene);
[[nodiscard]] std::vector<adapters::InputFile> input_of(const adapters::Code& code,
                                                        const scene::AnyScene& scene);

/// How far a run has come at this frame, in [0, 1].
[[nodiscard]] double progress_of(const scene::Scene& scene, const scene::Frame& frame);
[[nodiscard]] double progress_of(const scene::LatticeGas& scene, const scene::GasFrame& frame);
[[nodiscard]] double progress_of(const scene::SyntheticSignal& scene, const scene::GasFrame& frame);
[[nodiscard]] double progress_of(const scene::HopperAutomaton& scene,
                                 const scene::HopperFrame& frame);

}  // namespace crossgrain::run
