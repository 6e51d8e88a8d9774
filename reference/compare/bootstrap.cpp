#include "reference/compare/bootstrap.hpp"

#include "native/numerics/bootstrap.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace crossgrain::compare {
namespace {

constexpr std::size_t fewest_replicas = 4;

/// Mean of n of the n replicas, drawn with replacement.
double resampled_mean(const std::vector<double>& y, std::mt19937_64& random) {
    const double mean = numerics::mean_with_error(y).value;
    const auto n = static_cast<double>(y.size());
    double deviation = 0;
    // The remainder's bias is below replicas/2^64; std's own distribution differs by library.
    for (std::size_t i = 0; i < y.size(); ++i)
        deviation += (y[random() % y.size()] - mean) / n;
    return mean + deviation * std::sqrt(n / (n - 1));
}

}  // namespace

std::optional<double> bootstrap_error(std::span<const ReplicatedPoint> points,
                                      const FittedValue& fit, std::size_t resamples,
                                      std::uint64_t seed) {
    const auto few = [](const ReplicatedPoint& p) { return p.y.size() < fewest_replicas; };
    if (points.empty() || std::ranges::any_of(points, few)) return std::nullopt;
    std::mt19937_64 random(seed);
    std::vector<SweepPoint> drawn(points.size());
    return numerics::bootstrap_error(resamples, [&](std::size_t) {
        std::ranges::transform(points, drawn.begin(), [&](const ReplicatedPoint& p) {
            return SweepPoint{.x = p.x, .y = resampled_mean(p.y, random)};
        });
        return fit(drawn);
    });
}

std::optional<double> systematic_over_windows(std::span<const SweepPoint> points,
                                              const FittedValue& fit) {
    if (points.size() < 4) return std::nullopt;
    const std::array values{fit(points), fit(points.subspan(1)),
                            fit(points.first(points.size() - 1))};
    double low = 0, high = 0;
    for (const auto& value : values) {
        if (!value) return std::nullopt;
        low = std::min(low, *value - *values.front());
        high = std::max(high, *value - *values.front());
    }
    return (high - low) / 2;
}

}  // namespace crossgrain::compare
