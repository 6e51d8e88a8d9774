#include "cases/measure/statistics/autocorrelation.hpp"

#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace crossgrain::measure {
namespace {

constexpr std::size_t fewest_samples = 32;
constexpr double fewest_independent = 16;

double autocovariance(std::span<const double> deviations, std::size_t lag) {
    double sum = 0;
    for (std::size_t i = 0; i + lag < deviations.size(); ++i)
        sum += deviations[i] * deviations[i + lag];
    return sum / static_cast<double>(deviations.size() - lag);
}

/// How fast rho falls: Wolff's tau_W, or, where neighbours are anticorrelated and tau is below 1/2,
/// by |rho(1)|. Both are -S/ln|phi| for rho(t) = phi^t.
double decay_time(double tau, double first_rho) {
    constexpr double s = 1.5;
    if (tau > 0.5) return s / std::log((2 * tau + 1) / (2 * tau - 1));
    const double size = std::abs(first_rho);
    return size > 0 && size < 1 ? -s / std::log(size) : 0.0;
}

/// Wolff's g(W): positive while the window is too short.
double window_criterion(double decay, double window, double n) {
    if (decay == 0) return -1;
    return std::exp(-window / decay) - decay / std::sqrt(window * n);
}

}  // namespace

std::optional<AutocorrelatedMean> autocorrelated_mean(std::span<const double> series) {
    if (series.size() < fewest_samples) return std::nullopt;
    const auto n = static_cast<double>(series.size());
    const double mean = numerics::mean_with_error(series).value;
    std::vector<double> deviations(series.begin(), series.end());
    for (double& d : deviations)
        d -= mean;
    const double variance = autocovariance(deviations, 0);
    AutocorrelatedMean result{.value = mean, .independent = n};
    if (variance == 0) return result;
    const double first_rho = autocovariance(deviations, 1) / variance;
    double tau = 0.5;
    for (std::size_t window = 1; window <= series.size() / 2; ++window) {
        tau += autocovariance(deviations, window) / variance;
        const auto w = static_cast<double>(window);
        if (window_criterion(decay_time(tau, first_rho), w, n) >= 0) continue;
        const double unbiased = std::max(tau * (1 + (2 * w + 1) / n), 1 / n);
        result.window = window;
        result.time = unbiased;
        result.time_error = unbiased * std::sqrt(4 * std::max(0.0, w + 0.5 - unbiased) / n);
        result.standard_error = std::sqrt(2 * unbiased * variance / n);
        result.independent = n / (2 * unbiased);
        if (result.independent < fewest_independent) return std::nullopt;
        return result;
    }
    return std::nullopt;
}

}  // namespace crossgrain::measure
