// Errors of what is fitted to the points of a sweep: statistical, by resampling the replicas behind
// each point (Efron & Tibshirani, An Introduction to the Bootstrap (1993), chapters 6 and 8.3), and
// systematic, by the spread of the fit over its windows.
//
// Error propagation is linear in the points' errors; an exponent with a free cut-off or a ratio of
// two fitted numbers is not. Resampling does without that and without normal errors, but sees only
// what replicas see: not how far the points are off the law (sweep_fit.hpp does).
#pragma once

#include "reference/compare/sweep_fit.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::compare {

/// A point of a sweep with what each of its replicas measured.
struct ReplicatedPoint {
    double x = 0;
    std::vector<double> y;  ///< shape (replicas)
};

/// What is fitted, e.g. an exponent; nothing where the points do not allow it.
using FittedValue = std::function<std::optional<double>(std::span<const SweepPoint>)>;

/// Standard deviation of the fit over `resamples` sweeps whose points are means of as many replicas
/// drawn with replacement; each deviation from a point's mean is first enlarged by
/// sqrt(n/(n - 1)), which resampling n of n misses. The same seed gives the same error. Nothing if
/// a point has fewer than four replicas or fewer than 90 % of the resamples have a fit.
/// Throws std::invalid_argument for fewer than 100 resamples.
[[nodiscard]] std::optional<double> bootstrap_error(std::span<const ReplicatedPoint> points,
                                                    const FittedValue& fit,
                                                    std::size_t resamples = 400,
                                                    std::uint64_t seed = 1);

/// Half the range of the fit over three windows: all points, all but the first, all but the last
/// (ascending in x). How much the choice of the window decides. Nothing for fewer than four points
/// or if one of the windows has no fit.
[[nodiscard]] std::optional<double> systematic_over_windows(std::span<const SweepPoint> points,
                                                            const FittedValue& fit);

}  // namespace crossgrain::compare
