#include "reference/compare/sweep_fit.hpp"

#include "native/numerics/jackknife.hpp"
#include "native/numerics/levenberg_marquardt.hpp"
#include "native/numerics/line_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace crossgrain::compare {
namespace {

struct Logarithms {
    std::vector<double> x, y, errors;
};

/// Of x - k and y; nothing where one of them is not positive.
std::optional<Logarithms> logarithms(std::span<const SweepPoint> points, double k) {
    Logarithms logs;
    for (const SweepPoint& p : points) {
        if (!(p.x > k && p.y > 0)) return std::nullopt;
        logs.x.push_back(std::log(p.x - k));
        logs.y.push_back(std::log(p.y));
        logs.errors.push_back(p.standard_error / p.y);
    }
    if (std::ranges::max(logs.x) == std::ranges::min(logs.x)) return std::nullopt;
    return logs;
}

/// ln y = ln C + n ln(x - k): residuals and derivatives at the parameters ln C, n, k.
numerics::ResidualFunction outlet_residuals(std::span<const SweepPoint> points) {
    return [points](std::span<const double> p, std::span<double> r, std::span<double> jacobian) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double above = points[i].x - p[2];
            r[i] = p[0] + p[1] * std::log(above) - std::log(points[i].y);
            jacobian[3 * i] = 1;
            jacobian[3 * i + 1] = std::log(above);
            jacobian[3 * i + 2] = -p[1] / above;
        }
    };
}

/// n at the k of least squares.
std::optional<double> outlet_exponent(std::span<const SweepPoint> points) {
    constexpr int grid = 40;
    constexpr double largest = std::numeric_limits<double>::max();
    const double highest = 0.98 * std::ranges::min(points, {}, &SweepPoint::x).x;
    const double step = highest / grid;
    const auto line_at = [&](double k) -> std::optional<numerics::LineFit> {
        const auto logs = logarithms(points, k);
        if (!logs) return std::nullopt;
        return numerics::fit_line(logs->x, logs->y);
    };
    auto best = line_at(0);
    if (!best) return std::nullopt;
    double best_k = 0;
    for (int i = 1; i <= grid; ++i) {
        const auto line = line_at(i * step);
        if (!line || !(line->chi_squared < best->chi_squared)) continue;
        best = line;
        best_k = i * step;
    }
    const auto minimum = numerics::levenberg_marquardt(
        outlet_residuals(points), points.size(), std::array{best->intercept, best->slope, best_k},
        std::array<numerics::ParameterBounds, 3>{
            {{-largest, largest},
             {-largest, largest},
             {std::max(0.0, best_k - step), std::min(highest, best_k + step)}}});
    if (!minimum) return std::nullopt;
    return minimum->parameters[1];
}

}  // namespace

std::optional<SweepEstimate> fit_exponent(std::span<const SweepPoint> points) {
    if (points.size() < 3) return std::nullopt;
    const auto logs = logarithms(points, 0);
    if (!logs) return std::nullopt;
    const numerics::LineFit line = numerics::fit_line(logs->x, logs->y);
    return SweepEstimate{
        .value = line.slope,
        .standard_error =
            std::max(line.slope_error(), numerics::propagated_slope_error(logs->x, logs->errors)),
        .degrees_of_freedom = line.degrees_of_freedom};
}

std::optional<OutletLaw> fit_outlet_law(std::span<const SweepPoint> points) {
    if (points.size() < 3) return std::nullopt;
    std::vector<double> x, y;
    for (const SweepPoint& p : points) {
        if (!(p.y > 0)) return std::nullopt;
        x.push_back(p.x);
        y.push_back(std::pow(p.y, 2.0 / 3));
    }
    if (std::ranges::max(x) == std::ranges::min(x)) return std::nullopt;
    const numerics::LineFit line = numerics::fit_line(x, y);
    if (!(line.slope > 0)) return std::nullopt;
    // k = -a/b, var k = (var a + 2 k cov + k^2 var b)/b^2.
    const double k = -line.intercept / line.slope;
    const double factor = std::pow(line.slope, 1.5);
    OutletLaw law;
    law.factor = {.value = factor,
                  .standard_error = 1.5 * factor * line.slope_error() / line.slope,
                  .degrees_of_freedom = line.degrees_of_freedom};
    law.cut = {.value = k,
               .standard_error = line.error_at(k) / line.slope,
               .degrees_of_freedom = line.degrees_of_freedom};
    return law;
}

std::optional<SweepEstimate> fit_outlet_exponent(std::span<const SweepPoint> points) {
    if (points.size() < 5 || !logarithms(points, 0)) return std::nullopt;
    const auto value = outlet_exponent(points);
    if (!value) return std::nullopt;
    std::vector<double> without;
    for (std::size_t left_out = 0; left_out < points.size(); ++left_out) {
        std::vector<SweepPoint> rest(points.begin(), points.end());
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
        const auto own = outlet_exponent(rest);
        if (!own) return std::nullopt;
        without.push_back(*own);
    }
    return SweepEstimate{.value = *value,
                         .standard_error = numerics::jackknife_error(without),
                         .degrees_of_freedom = static_cast<double>(points.size()) - 3};
}

std::vector<std::optional<SweepEstimate>> local_slopes(std::span<const SweepPoint> points) {
    std::vector<std::optional<SweepEstimate>> slopes(points.size());
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const SweepPoint &a = points[i - 1], &b = points[i], &c = points[i + 1];
        const double below = b.x - a.x, above = c.x - b.x;
        if (!(below > 0 && above > 0)) continue;
        // Slope of Lagrange's parabola at b, as weights of the three values.
        const double wa = -above / (below * (below + above));
        const double wb = (above - below) / (below * above);
        const double wc = below / (above * (below + above));
        slopes[i] =
            SweepEstimate{.value = wa * a.y + wb * b.y + wc * c.y,
                          .standard_error = std::hypot(wa * a.standard_error, wb * b.standard_error,
                                                       wc * c.standard_error),
                          .degrees_of_freedom = std::numeric_limits<double>::infinity()};
    }
    return slopes;
}

}  // namespace crossgrain::compare
