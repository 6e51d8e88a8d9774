#include "cases/measure/pipe/pipe_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

/// Between the innermost surfaces of the frozen grains left and right of their middle.
std::optional<double> between_frozen(const scene::Scene& scene) {
    const auto& state = scene.initial;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (std::size_t i = 0; i < state.frozen.size(); ++i) {
        if (!state.frozen[i]) continue;
        lowest = std::min(lowest, state.x[i]);
        highest = std::max(highest, state.x[i]);
    }
    if (!(highest > lowest)) return std::nullopt;
    double left = lowest, right = highest;
    for (std::size_t i = 0; i < state.frozen.size(); ++i) {
        if (!state.frozen[i]) continue;
        const double radius = scene.grains.diameter_of(i) / 2;
        if (state.x[i] < (lowest + highest) / 2) {
            left = std::max(left, state.x[i] + radius);
        } else {
            right = std::min(right, state.x[i] - radius);
        }
    }
    return right - left;
}

double clear_width(const scene::Scene& scene) {
    if (const auto width = between_frozen(scene)) return *width;
    if (scene.backing) return scene.backing->right - scene.backing->left + scene.grains.diameter;
    if (scene.periodic_x) return *scene.periodic_x;
    throw std::invalid_argument("the pipe has no walls: no frozen grains, no backing planes");
}

}  // namespace

double PipeSection::down(double y) const {
    const double x = -y - length * std::floor(-y / length);
    return x < length ? x : 0.0;  // a tiny -y is rounded up to L
}

PipeSection pipe_section(const scene::Scene& scene) {
    if (!scene.periodic_y) {
        throw std::invalid_argument("the pipe is open: a period along y is needed");
    }
    PipeSection section{.length = *scene.periodic_y,
                        .clear_width = clear_width(scene),
                        .diameter = scene.grains.diameter,
                        .interval = scene.dt * static_cast<double>(scene.frame_every)};
    double area = 0;
    for (std::size_t i = 0; i < scene.grain_count(); ++i) {
        if (scene.has_frozen_grains() && scene.initial.frozen[i]) continue;
        const double d = scene.grains.diameter_of(i);
        section.mobile.push_back(i);
        area += std::numbers::pi / 4 * d * d;
    }
    if (section.mobile.empty()) throw std::invalid_argument("no grain of the scene can move");
    if (!(section.clear_width > 0)) throw std::invalid_argument("the walls of the pipe touch");
    section.area_fraction = area / (section.length * section.clear_width);
    return section;
}

}  // namespace crossgrain::measure
