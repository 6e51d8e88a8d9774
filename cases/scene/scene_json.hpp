// The scene as JSON: canonical (every field, fixed order of keys, numbers that read back exactly),
// so that its text identifies the run in the store.
#pragma once

#include "cases/scene/scene.hpp"

#include <nlohmann/json_fwd.hpp>

namespace crossgrain::scene {

[[nodiscard]] nlohmann::json to_json(const Scene& scene);

/// The settings a reader of a report wants to see: law variant, integrator, dt, steps, N.
[[nodiscard]] nlohmann::json settings_json(const Scene& scene);

}  // namespace crossgrain::scene
