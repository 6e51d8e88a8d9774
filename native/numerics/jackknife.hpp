// Standard error of a statistic that is not a mean, by leaving data out
// (Efron & Tibshirani, An Introduction to the Bootstrap (1993), Eq. 11.5).
#pragma once

#include <span>

namespace crossgrain::numerics {

/// se^2 = (g - 1)/g sum_i (theta_(i) - mean)^2 for the g statistics theta_(i), each computed
/// without the i-th of g equal parts of the data. Shape (parts), at least two.
[[nodiscard]] double jackknife_error(std::span<const double> statistics_without_part);

}  // namespace crossgrain::numerics
