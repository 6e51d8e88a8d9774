#include "cases/measure/statistics/power_law.hpp"

#include "native/numerics/jackknife.hpp"
#include "native/numerics/line_fit.hpp"

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
    std::vector<double> x, y;
    for (int k = k_min; k <= k_max; ++k) {
        const double s = spectrum[static_cast<std::size_t>(k)];
        if (!(s > 0) || !std::isfinite(s)) return std::nullopt;
        x.push_back(std::log(k));
        y.push_back(std::log(s));
    }
    const numerics::Line line = numerics::line_through(x, y);
    return PowerLaw{.exponent = line.slope, .amplitude = std::exp(line.intercept)};
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
    SlopeEstimate estimate{.value = *value,
                           .standard_error = numerics::jackknife_error(*without_one)};
    if (samples.size() >= fewest_for_blocks) {
        const auto without_two = slopes_without_blocks(samples, 2, k_min, k_max);
        if (!without_two) return std::nullopt;
        estimate.standard_error_blocks_of_two = numerics::jackknife_error(*without_two);
    }
    return estimate;
}

}  // namespace crossgrain::measure
