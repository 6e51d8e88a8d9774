// Exponent of a power law by least squares of logarithms, and its statistical error.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace crossgrain::measure {

/// S(K) = amplitude K^exponent.
struct PowerLaw {
    double exponent = 0;
    double amplitude = 0;
};

/// Least squares of log S against log K over K = k_min..k_max (both included), all points weighted
/// equally. `spectrum[K]` is S(K). Nothing if the window has fewer than two points, does not lie in
/// 1..size-1, or holds a value that is not positive.
[[nodiscard]] std::optional<PowerLaw> fit_power_law(std::span<const double> spectrum, int k_min,
                                                    int k_max);

/// The exponent of fit_power_law.
[[nodiscard]] std::optional<double> log_log_slope(std::span<const double> spectrum, int k_min,
                                                  int k_max);

/// Exponent of a mean spectrum with its errors.
struct SlopeEstimate {
    double value = 0;
    double standard_error = 0;                ///< jackknife, one sample deleted at a time
    double standard_error_blocks_of_two = 0;  ///< jackknife, two successive samples deleted at a
                                              ///< time; 0 for fewer than six samples
};

/// log_log_slope of the mean of `samples`, shape (samples, K). Nothing for fewer than three
/// samples, or if the slope does not exist for the mean of all of them or of any that the jackknife
/// leaves.
[[nodiscard]] std::optional<SlopeEstimate>
slope_of_mean(std::span<const std::vector<double>> samples, int k_min, int k_max);

/// Mean over the samples, shape (K); at least one sample.
[[nodiscard]] std::vector<double> mean_spectrum(std::span<const std::vector<double>> samples);

}  // namespace crossgrain::measure
