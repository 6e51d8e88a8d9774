// Errors of what is fitted to points, by resampling the points (Efron & Tibshirani, An Introduction
// to the Bootstrap (1993), chapters 9 and 13), and the spread of a fit over its windows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace crossgrain::compare {

struct FittedPoint {
    double x = 0, y = 0;
};

/// What is fitted, e.g. an exponent; not a number where the points do not allow it.
using Fit = std::function<double(std::span<const FittedPoint>)>;

struct BootstrapEstimate {
    double value = 0;           ///< of the points themselves
    double standard_error = 0;  ///< standard deviation over the resamples
    double low = 0, high = 0;   ///< 95 %: value -+ t_{0.975, points - 2} standard errors
    std::size_t resamples = 0;  ///< with a finite fit
};

/// Draws points with replacement `resamples` times; the same seed gives the same error. Pairs, not
/// residuals, are drawn: the scatter may depend on x. The variance is multiplied by
/// points/(points - 2), which resampling misses in a fit of two parameters.
/// Throws std::invalid_argument for fewer than four points, fewer than 100 resamples, a fit that is
/// not finite for the points themselves, or for more than half of the resamples.
[[nodiscard]] BootstrapEstimate bootstrap(std::span<const FittedPoint> points, const Fit& fit,
                                          std::size_t resamples = 1000, std::uint64_t seed = 1);

/// Exponent a of y = b x^a, by a straight line through the logarithms. Not a number for fewer than
/// two different x; points with x <= 0 or y <= 0 are left out.
[[nodiscard]] double power_law_exponent(std::span<const FittedPoint> points);

struct FitWindow {
    double from = 0, to = 0;  ///< of x, both included
};

/// Half the range of the fits over the windows: how much the choice of the window decides.
/// Windows in which the fit is not finite are left out. Throws std::invalid_argument if fewer than
/// two remain.
[[nodiscard]] double systematic_over_windows(std::span<const FittedPoint> points, const Fit& fit,
                                             std::span<const FitWindow> windows);

}  // namespace crossgrain::compare
