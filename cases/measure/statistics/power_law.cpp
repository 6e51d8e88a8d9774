#include "cases/measure/statistics/power_law.hpp"

#include "cases/measure/statistics/jackknife.hpp"

#include <algorithm>
#include <cmath>

namespace crossgrain::measure {
namespace {

// Slopes of the mean of all samples but those of one block of `length` successive ones; an
// incomplete last block is joined to the one before it.
std::optional<std::vector<double>>
slopes_without_blocks(std::span<const std::vector<double>> samples, std::size_t length, int k_min,
                      int k_max) {
    const std::size_t blocks = samples.size() / length;
    std::vector<double> total(samples.front().size(), 0.0);
    for (const auto& sample : samples) {
        std::ranges::transform(total, sample, total.begin(), std::plus{});
    }
    std::vector<double> slopes;
    for (std::size_t b = 0; b < blocks; ++b) {
        const std::size_t first = b * length;
        const std::size_t last = b + 1 == blocks ? samples.size() : first + length;
        // The common factor 1/n does not change a slope of logarithms.
        std::vector<double> rest = total;
        for (std::size_t i = first; i < last; ++i) {
            std::ranges::transform(rest, samples[i], rest.begin(), std::minus{});
        }
        const auto slope = log_log_slope(rest, k_min, k_max);
        if (!slope) return std::nullopt;
        slopes.push_back(*slope);
    }
    return slopes;
}

}  // namespace

std::optional<PowerLaw> fit_power_law(std::span<const double> spectrum, int k_min, int k_max) {
    if (k_min < 1 || k_max <= k_min || static_cast<std::size_t>(k_max) >= spectrum.size()) {
        return std::nullopt;
    }
    double mean_x = 0, mean_y = 0;
    const double n = k_max - k_min + 1;
    for (int k = k_min; k <= k_max; ++k) {
        const double s = spectrum[static_cast<std::size_t>(k)];
        if (!(s > 0) || !std::isfinite(s)) return std::nullopt;
        mean_x += std::log(k) / n;
        mean_y += std::log(s) / n;
    }
    double xx = 0, xy = 0;
    for (int k = k_min; k <= k_max; ++k) {
        const double x = std::log(k) - mean_x;
        xx += x * x;
        xy += x * (std::log(spectrum[static_cast<std::size_t>(k)]) - mean_y);
    }
    const double exponent = xy / xx;
    return PowerLaw{.exponent = exponent, .amplitude = std::exp(mean_y - exponent * mean_x)};
}

std::optional<double> log_log_slope(std::span<const double> spectrum, int k_min, int k_max) {
    const auto law = fit_power_law(spectrum, k_min, k_max);
    if (!law) return std::nullopt;
    return law->exponent;
}

std::vector<double> mean_spectrum(std::span<const std::vector<double>> samples) {
    std::vector<double> mean(samples.front().size(), 0.0);
    for (const auto& sample : samples) {
        std::ranges::transform(mean, sample, mean.begin(), std::plus{});
    }
    for (double& value : mean)
        value /= static_cast<double>(samples.size());
    return mean;
}

std::optional<SlopeEstimate> slope_of_mean(std::span<const std::vector<double>> samples, int k_min,
                                           int k_max) {
    constexpr std::size_t fewest = 3, fewest_for_blocks = 6;
    if (samples.size() < fewest) return std::nullopt;
    const auto value = log_log_slope(mean_spectrum(samples), k_min, k_max);
    const auto without_one = slopes_without_blocks(samples, 1, k_min, k_max);
    if (!value || !without_one) return std::nullopt;
    SlopeEstimate estimate{.value = *value, .standard_error = jackknife_error(*without_one)};
    if (samples.size() >= fewest_for_blocks) {
        const auto without_two = slopes_without_blocks(samples, 2, k_min, k_max);
        if (!without_two) return std::nullopt;
        estimate.standard_error_blocks_of_two = jackknife_error(*without_two);
    }
    return estimate;
}

}  // namespace crossgrain::measure
