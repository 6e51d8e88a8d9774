// The scene of `crossgrain bench dem`: the fluidised bed of the paper (Gamma = 2.19) at t = 40.
// Before that the crystal moves as a column and every neighbour list looks better than it is.
#pragma once

#include "cases/scene/scene.hpp"
#include "native/dem/system.hpp"

#include <cstddef>
#include <cstdint>

namespace crossgrain::bench {

/// The paper's 1024 grains on a period of 128 under a lid of mass 100, or as many more as wide.
[[nodiscard]] dem::Parameters bed_parameters(std::size_t grains);

/// The bed at t = 40, by the fastest native kernel.
[[nodiscard]] dem::State fluidised(std::size_t grains);

/// Copies side by side, as one bed of the same depth. They part within a few contact times: each
/// grain gets its own kick of 1e-3.
[[nodiscard]] dem::State side_by_side(const dem::State& bed, std::size_t copies);

/// The same for all codes, frames at the start and the end only.
[[nodiscard]] scene::Scene scene_of(const dem::State& state, std::int64_t steps);

}  // namespace crossgrain::bench
