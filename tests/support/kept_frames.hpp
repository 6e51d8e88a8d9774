// Frames that outlive their run, and the difference between two trajectories.
#pragma once

#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"
#include "tests/support/reference_dem.hpp"
#include "tests/support/reference_friction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace crossgrain::tests {

/// A frame that owns its arrays.
struct KeptFrame {
    explicit KeptFrame(const scene::Frame& frame)
        : step(frame.step), time(frame.time), x(frame.x.begin(), frame.x.end()),
          y(frame.y.begin(), frame.y.end()), vx(frame.vx.begin(), frame.vx.end()),
          vy(frame.vy.begin(), frame.vy.end()), omega(frame.omega.begin(), frame.omega.end()),
          lid(frame.lid) {}

    [[nodiscard]] scene::Frame view() const {
        return {.step = step,
                .time = time,
                .x = x,
                .y = y,
                .vx = vx,
                .vy = vy,
                .lid = lid,
                .omega = omega};
    }

    std::int64_t step;
    double time;
    std::vector<double> x, y, vx, vy, omega;
    std::optional<scene::LidState> lid;
};

inline std::vector<KeptFrame> reference_frames(const scene::Scene& scene) {
    std::vector<KeptFrame> frames;
    ReferenceDem(scene).run([&](const scene::Frame& frame) { frames.emplace_back(frame); });
    return frames;
}

/// Of a frictional scene.
inline std::vector<KeptFrame> reference_frames(const scene::Scene& scene,
                                               const scene::FrictionConventions& conventions,
                                               Coordinates coordinates = Coordinates::unwrapped) {
    std::vector<KeptFrame> frames;
    ReferenceFriction(scene, conventions, coordinates).run([&](const scene::Frame& frame) {
        frames.emplace_back(frame);
    });
    return frames;
}

/// Largest difference of any position, velocity or angular velocity in any frame; infinite when the
/// trajectories do not have the same frames.
inline double largest_difference(const std::vector<KeptFrame>& a, const std::vector<KeptFrame>& b) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if (a.size() != b.size() || a.empty()) return infinite;
    double largest = 0;
    const auto compare = [&](const std::vector<double>& p, const std::vector<double>& q) {
        if (p.size() != q.size()) largest = infinite;
        for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i) {
            largest = std::max(largest, std::abs(p[i] - q[i]));
        }
    };
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (a[k].step != b[k].step || a[k].lid.has_value() != b[k].lid.has_value()) return infinite;
        compare(a[k].x, b[k].x);
        compare(a[k].y, b[k].y);
        compare(a[k].vx, b[k].vx);
        compare(a[k].vy, b[k].vy);
        compare(a[k].omega, b[k].omega);
        if (!a[k].lid) continue;
        compare({a[k].lid->height, a[k].lid->velocity}, {b[k].lid->height, b[k].lid->velocity});
    }
    return largest;
}

}  // namespace crossgrain::tests
