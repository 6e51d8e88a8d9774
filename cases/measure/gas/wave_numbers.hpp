// The structure factor S(k) of density waves, of particles and of grains alike.
#pragma once

#include "cases/measure/results.hpp"

#include <span>
#include <vector>

namespace crossgrain::measure {

/// Series "wave-numbers": k, S, and its standard error over the samples, shape (samples, k); k = 0
/// is left out.
[[nodiscard]] Series wave_number_series(std::span<const std::vector<double>> samples);

/// Appends `wave_number_exponent`, the slope of log S over log k for k_min ... k_max; its
/// systematic error is half the spread over that window and its lower and upper half. Nothing
/// without a slope (power_law.hpp).
void append_wave_number_exponent(std::span<const std::vector<double>> samples, int k_min, int k_max,
                                 Results& results);

}  // namespace crossgrain::measure
