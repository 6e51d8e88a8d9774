#include "reference/compare/bootstrap.hpp"

#include "cases/measure/mean_with_error.hpp"
#include "reference/compare/line_fit.hpp"
#include "reference/compare/student.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace crossgrain::compare {

BootstrapEstimate bootstrap(std::span<const FittedPoint> points, const Fit& fit,
                            std::size_t resamples, std::uint64_t seed) {
    if (points.size() < 4 || resamples < 100) {
        throw std::invalid_argument("a bootstrap needs four points and 100 resamples or more");
    }
    BootstrapEstimate estimate{.value = fit(points)};
    if (!std::isfinite(estimate.value)) {
        throw std::invalid_argument("nothing can be fitted to these points");
    }
    std::mt19937_64 random(seed);
    std::vector<FittedPoint> drawn(points.size());
    std::vector<double> fits;
    for (std::size_t i = 0; i < resamples; ++i) {
        // The remainder's bias is below points/2^64; std's own distribution differs by library.
        std::ranges::generate(drawn, [&] { return points[random() % points.size()]; });
        if (const double value = fit(drawn); std::isfinite(value)) fits.push_back(value);
    }
    if (2 * fits.size() < resamples) {
        throw std::invalid_argument("too few different points: most resamples have no fit");
    }
    const auto mean = measure::mean_with_error(fits);
    const auto n = static_cast<double>(points.size());
    estimate.standard_error =
        mean.standard_error * std::sqrt(static_cast<double>(fits.size())) * std::sqrt(n / (n - 2));
    const double half = student_quantile(0.975, n - 2) * estimate.standard_error;
    estimate.low = estimate.value - half;
    estimate.high = estimate.value + half;
    estimate.resamples = fits.size();
    return estimate;
}

double power_law_exponent(std::span<const FittedPoint> points) {
    double n = 0, mean_x = 0, mean_y = 0;
    const auto positive = [](const FittedPoint& p) { return p.x > 0 && p.y > 0; };
    for (const auto& p : points) {
        if (!positive(p)) continue;
        n += 1;
        mean_x += std::log(p.x);
        mean_y += std::log(p.y);
    }
    mean_x /= n;
    mean_y /= n;
    double xx = 0, xy = 0;
    for (const auto& p : points) {
        if (!positive(p)) continue;
        const double x = std::log(p.x) - mean_x;
        xx += x * x;
        xy += x * (std::log(p.y) - mean_y);
    }
    return xx > 0 ? xy / xx : std::numeric_limits<double>::quiet_NaN();
}

double systematic_over_windows(std::span<const FittedPoint> points, const Fit& fit,
                               std::span<const FitWindow> windows) {
    std::vector<double> fits;
    for (const auto& window : windows) {
        std::vector<FittedPoint> inside;
        std::ranges::copy_if(points, std::back_inserter(inside),
                             [&](const auto& p) { return p.x >= window.from && p.x <= window.to; });
        if (const double value = fit(inside); std::isfinite(value)) fits.push_back(value);
    }
    if (fits.size() < 2) throw std::invalid_argument("fewer than two windows have a fit");
    const auto [low, high] = std::ranges::minmax(fits);
    return (high - low) / 2;
}

}  // namespace crossgrain::compare
