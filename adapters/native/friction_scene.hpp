// Scenes for native/friction: rotating discs with friction, grains that differ, drag, backing
// planes. Everything else runs on native/dem, which pays for none of it.
#pragma once

#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"
#include "native/friction/system.hpp"

#include <optional>
#include <string>

namespace crossgrain::adapters {

/// Whether the scene has something that only native/friction has.
[[nodiscard]] bool needs_friction_engine(const scene::Scene& scene);

/// Why native/friction cannot run such a scene exactly, or nothing if it can.
[[nodiscard]] std::optional<std::string> friction_cannot_express(const scene::Scene& scene);

/// The scene for the engine. Conventions that are absent ("own") are those of "liggghts".
[[nodiscard]] friction::Parameters friction_parameters(const scene::Scene& scene);
[[nodiscard]] friction::State friction_initial_state(const scene::Scene& scene);

/// Views of the state; with angular velocities when the scene has friction.
[[nodiscard]] scene::Frame frame_of(const friction::State& state, const scene::Scene& scene);

}  // namespace crossgrain::adapters
