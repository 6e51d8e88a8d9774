// Velocity of a density pattern of grains by maximal overlap (overlap_velocity.hpp): one run is cut
// into eight blocks, the samples. Intervals are those in which grains fall a given way at their
// mean velocity, so that they suit every density. The greatest overlap is looked for within 100
// diameters of where it is expected: first where the grains are.
//
// Single grains, which move at their own velocity, pull early shifts towards it; the shortest
// interval must be long enough for them to have parted from the wave.
#pragma once

#include "cases/measure/options.hpp"
#include "cases/measure/pipe/pipe_record.hpp"
#include "cases/measure/waves/overlap_velocity.hpp"

#include <optional>

namespace crossgrain::measure {

/// All in diameters.
struct PipeOverlapOptions {
    double lag_min = 30;
    double lag_max = 90;
    double lag_step = 10;
    double smoothing = 20;
};

inline OptionKeys option_keys(PipeOverlapOptions& o) {
    return {{"lag_min", &o.lag_min, Range::positive(),
             "way fallen in the shortest interval, in diameters"},
            {"lag_max", &o.lag_max, Range::positive(),
             "in the longest, > lag_min; at most 0.4 L is used"},
            {"lag_step", &o.lag_step, Range::positive(), "between them, in diameters"},
            {"smoothing", &o.smoothing, Range::positive(),
             "of the fields, in diameters: single grains in passing must not decide"}};
}

/// Nothing for a gas at rest on average, or if the frames give fewer than three different
/// intervals that fit into a block. Throws std::invalid_argument unless 0 < lag_min < lag_max,
/// lag_step > 0 and smoothing is in (0, L/2).
[[nodiscard]] std::optional<OverlapVelocity> pipe_overlap(const PipeRecord& record,
                                                          const PipeOverlapOptions& options);

}  // namespace crossgrain::measure
