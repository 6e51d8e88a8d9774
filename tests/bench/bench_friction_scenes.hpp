// The scenes of `crossgrain bench dem-friction`: rotating grains with friction in a dilute pipe and
// in a dense hopper, after they have found their own state. Units d = m = g = 1.
#pragma once

#include "cases/scene/scene.hpp"

#include <cstddef>

namespace crossgrain::bench {

/// 420 grains between two rows of staggered frozen discs, phi = 0.15, with the waves that come by
/// themselves.
[[nodiscard]] scene::Scene pipe_of_grains();

/// A filling of this height that has settled behind a plug and has begun to flow: outlet 20, walls
/// of touching discs at 30 degrees to the vertical.
[[nodiscard]] scene::Scene hopper_of_grains(double height);

/// Those that are not frozen.
[[nodiscard]] std::size_t mobile_grains(const scene::Scene& s);

}  // namespace crossgrain::bench
