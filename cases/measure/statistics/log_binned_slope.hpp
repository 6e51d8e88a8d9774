// Exponent of a noise spectrum P(f) ~ f^-alpha: least squares of log P against log f over bins that
// are equally wide in log f, each with the same weight, so that high frequencies, of which there
// are many, do not decide it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace crossgrain::measure {

/// Frequencies in cycles per record, 0 < low < high <= 1/2.
struct FrequencyWindow {
    double low = 0;
    double high = 0;
};

inline constexpr double bins_per_decade = 12;

/// Slope (-alpha) over the window; power[k] is P at f = k/points. A bin holds the means of log f
/// and log P, for which a pure power law gives its exponent exactly, whatever the bins hold.
/// Nothing if fewer than three bins hold a frequency, or if P is not positive and finite somewhere
/// in the window.
[[nodiscard]] std::optional<double> log_binned_slope(std::span<const double> power,
                                                     std::size_t points, FrequencyWindow window);

}  // namespace crossgrain::measure
