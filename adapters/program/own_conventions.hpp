// A code has one way to follow a frictional contact from step to step, and refuses the others.
#pragma once

#include "cases/scene/scene.hpp"

#include <optional>
#include <string>

namespace crossgrain::adapters {

/// Whether two sets of conventions make the same force of this friction: without history nothing is
/// rotated, and what is cut matters only where a spring and a dashpot add up.
[[nodiscard]] bool same_force(const scene::Friction& friction, const scene::FrictionConventions& a,
                              const scene::FrictionConventions& b);

/// Why a code whose conventions have the name `own` (scene::conventions_named) cannot run the
/// scene, with the nearest that it could; nothing if it can, or if there is no friction.
[[nodiscard]] std::optional<std::string> foreign_conventions(const scene::Scene& scene,
                                                             const std::string& own);

}  // namespace crossgrain::adapters
