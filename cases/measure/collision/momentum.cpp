#include "cases/measure/collision/momentum.hpp"

#include <algorithm>
#include <cmath>

namespace crossgrain::measure {

Momentum::Momentum(const scene::Scene& scene)
    : grains_(scene.grains),
      x_conserved_(scene.drag == 0 && !scene.backing &&
                   std::ranges::none_of(scene.initial.frozen, [](bool f) { return f; })),
      y_conserved_(x_conserved_ && scene.gravity == 0 && !scene.plates.bottom &&
                   std::holds_alternative<std::monostate>(scene.plates.lid)) {}

void Momentum::add(const scene::Frame& frame) {
    if (!x_conserved_) return;
    double px = 0, py = 0, squares = 0;
    for (std::size_t i = 0; i < frame.vx.size(); ++i) {
        const double mass = grains_.mass_of(i);
        px += mass * frame.vx[i];
        py += mass * frame.vy[i];
        squares += mass * mass * (frame.vx[i] * frame.vx[i] + frame.vy[i] * frame.vy[i]);
    }
    if (frames_ == 0) {
        first_x_ = px;
        first_y_ = py;
    }
    ++frames_;
    worst_x_ = std::max(worst_x_, std::abs(px - first_x_));
    worst_y_ = std::max(worst_y_, std::abs(py - first_y_));
    scale_ = std::max(scale_, std::sqrt(squares));
}

void Momentum::finish(Results& results) {
    if (!x_conserved_ || frames_ < 2 || scale_ == 0) return;
    results.measurements.push_back({.observable = "momentum_drift_x",
                                    .value = worst_x_ / scale_,
                                    .n = frames_,
                                    .settings = {}});
    if (!y_conserved_) return;
    results.measurements.push_back({.observable = "momentum_drift_y",
                                    .value = worst_y_ / scale_,
                                    .n = frames_,
                                    .settings = {}});
}

}  // namespace crossgrain::measure
