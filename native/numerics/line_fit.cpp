#include "native/numerics/line_fit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace crossgrain::numerics {
namespace {

void check(std::span<const double> x, std::span<const double> y, std::span<const double> errors) {
    const auto finite = [](double value) { return std::isfinite(value); };
    if (x.size() != y.size() || x.size() != errors.size() || x.size() < 2) {
        throw std::invalid_argument("a line needs two or more points, each with x, y and error");
    }
    if (!std::ranges::all_of(x, finite) || !std::ranges::all_of(y, finite) ||
        !std::ranges::all_of(errors, [&](double e) { return finite(e) && e > 0; })) {
        throw std::invalid_argument("a line needs finite points and errors > 0");
    }
    if (std::ranges::all_of(x, [&](double value) { return value == x.front(); })) {
        throw std::invalid_argument("a line needs points at different x");
    }
}

}  // namespace

double LineFit::intercept_error() const {
    return std::sqrt(intercept_variance);
}
double LineFit::slope_error() const {
    return std::sqrt(slope_variance);
}

double LineFit::error_at(double x) const {
    const double variance = intercept_variance + 2 * x * covariance + x * x * slope_variance;
    return std::sqrt(std::max(0.0, variance));
}

LineFit fit_line(std::span<const double> x, std::span<const double> y,
                 std::span<const double> standard_errors) {
    check(x, y, standard_errors);
    double weights = 0, mean_x = 0, mean_y = 0;
    const auto weight = [&](std::size_t i) {
        return 1 / (standard_errors[i] * standard_errors[i]);
    };
    for (std::size_t i = 0; i < x.size(); ++i) {
        weights += weight(i);
        mean_x += weight(i) * x[i];
        mean_y += weight(i) * y[i];
    }
    mean_x /= weights;
    mean_y /= weights;
    // About the weighted centre slope and height are uncorrelated, and little is lost in round-off.
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += weight(i) * (x[i] - mean_x) * (x[i] - mean_x);
        xy += weight(i) * (x[i] - mean_x) * (y[i] - mean_y);
    }
    LineFit fit{.intercept = mean_y - xy / xx * mean_x,
                .slope = xy / xx,
                .intercept_variance = 1 / weights + mean_x * mean_x / xx,
                .slope_variance = 1 / xx,
                .covariance = -mean_x / xx,
                .degrees_of_freedom = static_cast<double>(x.size()) - 2};
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double residual = y[i] - fit.at(x[i]);
        fit.chi_squared += weight(i) * residual * residual;
    }
    return fit;
}

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
    if (x.size() < 3) {
        throw std::invalid_argument("a line through points of unknown error needs three of them");
    }
    LineFit fit = fit_line(x, y, std::vector<double>(x.size(), 1.0));
    fit.scale_covariance(fit.chi_squared / fit.degrees_of_freedom);
    return fit;
}

Line line_through(std::span<const double> x, std::span<const double> y) {
    const LineFit fit = fit_line(x, y, std::vector<double>(x.size(), 1.0));
    return {.intercept = fit.intercept, .slope = fit.slope};
}

double propagated_slope_error(std::span<const double> x, std::span<const double> standard_errors) {
    if (x.size() != standard_errors.size()) {
        throw std::invalid_argument("the error of a slope needs an error for every x");
    }
    double mean = 0, xx = 0, sum = 0;
    for (const double value : x)
        mean += value / static_cast<double>(x.size());
    for (const double value : x)
        xx += (value - mean) * (value - mean);
    if (!(xx > 0)) throw std::invalid_argument("a slope needs points at different x");
    for (std::size_t i = 0; i < x.size(); ++i)
        sum += std::pow((x[i] - mean) * standard_errors[i] / xx, 2);
    return std::sqrt(sum);
}

void LineFit::scale_covariance(double factor) {
    intercept_variance *= factor;
    slope_variance *= factor;
    covariance *= factor;
}

}  // namespace crossgrain::numerics
