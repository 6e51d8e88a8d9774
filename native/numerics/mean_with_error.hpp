// Mean and standard error of independent samples.
#pragma once

#include <cstddef>
#include <span>

namespace crossgrain::numerics {

struct MeanWithError {
    double value = 0;
    double standard_error = 0;  ///< s/sqrt(n), s^2 the unbiased variance; 0 for one sample
    std::size_t n = 0;
};

/// Two-pass, so that the scatter of nearly equal samples is not lost in round-off. `samples` must
/// not be empty.
[[nodiscard]] MeanWithError mean_with_error(std::span<const double> samples);

}  // namespace crossgrain::numerics
