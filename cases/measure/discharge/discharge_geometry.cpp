#include "cases/measure/discharge/discharge_geometry.hpp"

#include "native/numerics/line_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

void require(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument(what);
}

/// Least squares of |x - axis| = half_width + tangent (y - level) through all wall grains.
void fit_lines(HopperWalls& walls, const std::vector<double>& away,
               const std::vector<double>& above) {
    require(std::ranges::max(above) > std::ranges::min(above),
            "the frozen grains lie in one row: they make no hopper");
    const numerics::Line line = numerics::line_through(above, away);
    walls.tangent = line.slope;
    walls.half_width = line.intercept;
    require(walls.tangent > -1e-9, "the walls of the hopper lean inward");
    for (std::size_t i = 0; i < away.size(); ++i) {
        const double off = away[i] - walls.half_width - walls.tangent * above[i];
        require(
            std::abs(off) <= walls.diameter,
            fmt::format("the walls of the hopper are not straight: a frozen grain is {:.3g} off "
                        "the line through them",
                        std::abs(off)));
    }
}

}  // namespace

double HopperWalls::from_wall(double x, double y) const {
    const double inside = half_width + tangent * (y - level) - std::abs(x - axis);
    return inside / std::hypot(1.0, tangent);
}

double HopperWalls::area_below(double h) const {
    return outlet * h + tangent * h * h;
}

double HopperWalls::height_of(double area) const {
    // The stable root, which is area/outlet for upright walls.
    return 2 * area / (outlet + std::sqrt(outlet * outlet + 4 * tangent * area));
}

HopperWalls hopper_walls(const scene::Scene& scene) {
    const auto& state = scene.initial;
    HopperWalls walls{.diameter = scene.grains.diameter};
    double left = std::numeric_limits<double>::infinity(), right = -left, lowest = left,
           highest = -left;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        if (state.frozen.empty() || !state.frozen[i]) {
            walls.mobile.push_back(i);
            continue;
        }
        left = std::min(left, state.x[i]);
        right = std::max(right, state.x[i]);
        lowest = std::min(lowest, state.y[i]);
        highest = std::max(highest, state.y[i]);
    }
    require(right > left, "the hopper has no walls of frozen grains");
    require(!walls.mobile.empty(), "no grain of the scene can move");
    walls.axis = (left + right) / 2;
    walls.level = lowest;
    walls.height = highest - lowest;
    std::vector<double> away, above;
    double clear = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        if (!state.frozen[i]) continue;
        away.push_back(std::abs(state.x[i] - walls.axis));
        above.push_back(state.y[i] - lowest);
        clear = std::min(clear, away.back() - scene.grains.diameter_of(i) / 2);
    }
    fit_lines(walls, away, above);
    walls.outlet = 2 * clear;
    require(walls.outlet > 0, "the walls of the hopper leave no outlet");
    return walls;
}

}  // namespace crossgrain::measure
