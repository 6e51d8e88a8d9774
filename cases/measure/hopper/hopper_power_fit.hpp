// Fits of y = b x^a that differ in what they weigh: the paper's "exponential fit 1/P = b theta^a"
// (Gremaud, section 3a) does not say which.
#pragma once

#include <optional>
#include <span>

namespace crossgrain::measure {

struct PowerFit {
    double exponent = 0;   ///< a
    double amplitude = 0;  ///< b
};

/// Least squares of ln y against ln x: all points weigh the same on a log-log plot. Nothing for
/// fewer than two different x or for x or y that are not finite and positive.
[[nodiscard]] std::optional<PowerFit> fit_logarithms(std::span<const double> x,
                                                     std::span<const double> y);

/// Unweighted least squares of y itself: large y decide. The exponent is sought in [-20, 20].
/// Nothing in the cases above.
[[nodiscard]] std::optional<PowerFit> fit_unweighted(std::span<const double> x,
                                                     std::span<const double> y);

}  // namespace crossgrain::measure
