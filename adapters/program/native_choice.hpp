// Choices of a scene that only the project's own engine offers.
#pragma once

#include "cases/scene/scene.hpp"

#include <optional>
#include <string>

namespace crossgrain::adapters {

/// Why no foreign code can run this scene (fixed lattice neighbours, mixed precision), with the
/// nearest choice that it could; nothing if there is no such reason.
[[nodiscard]] std::optional<std::string> native_choice(const scene::Scene& scene);

}  // namespace crossgrain::adapters
