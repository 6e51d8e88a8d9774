// Time mean of a sampled quantity with its standard error, in driven and undriven scenes.
#pragma once

#include "cases/measure/statistics/blocking.hpp"

#include <optional>
#include <span>

namespace crossgrain::measure {

/// Mean of `values` at equally spaced, ascending `times`, from t = `skip` on.
///
/// Under a drive of period T the samples are first averaged over whole periods (an incomplete last
/// one is left out): what the drive repeats is no error of the mean. The standard error is that of
/// blocked_mean or, if larger, that of the integrated autocorrelation time (autocorrelation.hpp;
/// series long enough for it only): noise makes either too small now and then. `blocks` is the
/// smaller number of independent samples of the two. Nothing if blocked_mean has none.
[[nodiscard]] std::optional<BlockedMean> time_mean(std::span<const double> times,
                                                   std::span<const double> values, double skip,
                                                   std::optional<double> period);

}  // namespace crossgrain::measure
