// Exponent of a power law by least squares of logarithms.
#pragma once

#include <optional>
#include <span>

namespace crossgrain::measure {

/// Slope of log S against log K over K = k_min..k_max (both included), all points weighted equally.
/// `spectrum[K]` is S(K). Nothing if the window has fewer than two points, does not lie in
/// 1..size-1, or holds a value that is not positive.
[[nodiscard]] std::optional<double> log_log_slope(std::span<const double> spectrum, int k_min,
                                                  int k_max);

}  // namespace crossgrain::measure
