// Velocity of a density pattern of grains by maximal overlap (overlap_velocity.hpp): one run is cut
// into eight blocks, the samples. Intervals are those in which grains fall a given way at their
// mean velocity, so that they suit every density. The greatest overlap is looked for within 100
// diameters of where it is expected: first where the grains are.
//
// Single grains, which move at their own velocity, pull early shifts towards it; the shortest
// interval must be long enough for them to have parted from the wave.
#pragma once

#include "cases/measure/pipe/pipe_record.hpp"
#include "cases/measure/waves/overlap_velocity.hpp"

#include <optional>

namespace crossgrain::measure {

/// All in diameters.
struct PipeOverlapOptions {
    double lag_min = 30;    ///< way fallen in the shortest interval, > 0
    double lag_max = 90;    ///< in the longest; at most 0.4 L is used
    double lag_step = 10;   ///< > 0
    double smoothing = 20;  ///< of the fields: single grains in passing must not decide, > 0
};

/// Nothing for a gas at rest on average, or if the frames give fewer than three different
/// intervals that fit into a block. Throws std::invalid_argument unless 0 < lag_min < lag_max,
/// lag_step > 0 and smoothing is in (0, L/2).
[[nodiscard]] std::optional<OverlapVelocity> pipe_overlap(const PipeRecord& record,
                                                          const PipeOverlapOptions& options);

}  // namespace crossgrain::measure
