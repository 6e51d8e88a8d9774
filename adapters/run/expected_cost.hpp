// What a run will cost, roughly: for the order of runs, progress and the time said before a start.
#pragma once

#include "adapters/run/plan.hpp"

namespace crossgrain::run {

/// CPU seconds, from typical rates of each code on one current core (a factor of two either way).
/// No result depends on it.
[[nodiscard]] double expected_seconds(const PlannedRun& run);

}  // namespace crossgrain::run
