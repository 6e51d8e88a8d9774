// What a run may ask for at most, whatever its model. Larger sizes are refused when a scene is
// read, before anything is made; memory has a limit of its own (native/base/memory_budget.hpp).
#pragma once

#include <cstdint>

namespace crossgrain::scene {

/// Grains of a scene, frozen ones included: beyond what any of the codes runs on one machine.
inline constexpr std::int64_t most_grains = 10'000'000;

/// Time steps.
inline constexpr std::int64_t most_steps = 1'000'000'000'000;

/// Frames: estimators keep a number or more of each.
inline constexpr std::int64_t most_frames = 10'000'000;

/// Distance of a grain from the origin, in diameters: positions of 17 digits still have nine behind
/// the point.
inline constexpr double farthest = 1e7;

}  // namespace crossgrain::scene
