// Standard error of a statistic by resampling
// (Efron & Tibshirani, An Introduction to the Bootstrap (1993), chapter 6).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace crossgrain::numerics {

/// The statistic of the resample with this number (0, 1, ...), which the caller draws; nothing
/// where that resample has none.
using ResampledStatistic = std::function<std::optional<double>(std::size_t)>;

/// Standard deviation of the statistic over `resamples` resamples, called in ascending order.
/// Nothing if fewer than 90 % of the resamples have a value: a statistic that most resamples do not
/// have is not known. Throws std::invalid_argument for fewer than 100 resamples.
[[nodiscard]] std::optional<double> bootstrap_error(std::size_t resamples,
                                                    const ResampledStatistic& statistic);

}  // namespace crossgrain::numerics
