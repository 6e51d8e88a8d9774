#include "cases/scene/frame_guard.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain::scene {
namespace {

double smallest_diameter(const Grains& grains) {
    return grains.differ() ? *std::min_element(grains.diameters.begin(), grains.diameters.end())
                           : grains.diameter;
}

}  // namespace

FrameGuard::FrameGuard(const Scene& scene, FrameSink next)
    : scene_(scene), next_(std::move(next)), smallest_diameter_(smallest_diameter(scene.grains)),
      motion_(scene) {}

void FrameGuard::operator()(const Frame& frame) {
    check_schedule(frame);
    check_shape(frame);
    check_values(frame);
    motion_.check(frame);
    ++frames_;
    expected_step_ += scene_.frame_every;
    next_(frame);
}

void FrameGuard::check_schedule(const Frame& frame) const {
    if (expected_step_ > scene_.steps && frame.step > scene_.steps) {
        throw TrajectoryError(
            fmt::format("frame at step {} lies beyond the last step {}", frame.step, scene_.steps));
    }
    const std::int64_t last_step = expected_step_ - scene_.frame_every;
    if (frames_ == 0 && frame.step < 0) {
        throw TrajectoryError(
            fmt::format("frame at step {} comes before step 0, the first", frame.step));
    }
    if (frame.step <= last_step) {
        throw TrajectoryError(fmt::format(
            "frame at step {} comes after the frame at step {}: frames overlap (was a run appended "
            "to an older trajectory?)",
            frame.step, last_step));
    }
    if (frame.step < expected_step_) {
        throw TrajectoryError(
            fmt::format("frame at step {} lies between steps {} and {}, at which the scene has "
                        "frames (another time step, or frames too often?)",
                        frame.step, last_step, expected_step_));
    }
    if (frame.step > expected_step_) {
        throw TrajectoryError(fmt::format("frame at step {} is missing (found step {} instead)",
                                          expected_step_, frame.step));
    }
}

void FrameGuard::check_shape(const Frame& frame) const {
    const std::size_t n = scene_.grain_count();
    if (frame.x.size() != n || frame.y.size() != n || frame.vx.size() != n ||
        frame.vy.size() != n) {
        throw TrajectoryError(fmt::format("frame at step {} holds {} grains, the scene has {}",
                                          frame.step, frame.x.size(), n));
    }
    if (frame.lid.has_value() != scene_.has_free_lid()) {
        throw TrajectoryError(fmt::format("frame at step {} {} a lid, the scene {}", frame.step,
                                          frame.lid ? "has" : "lacks",
                                          scene_.has_free_lid() ? "has one" : "has none"));
    }
    if (scene_.has_friction() && frame.omega.size() != n) {
        throw TrajectoryError(fmt::format(
            "frame at step {} holds angular velocities of {} grains, the scene has {} with "
            "friction",
            frame.step, frame.omega.size(), n));
    }
}

void FrameGuard::check_values(const Frame& frame) const {
    const std::size_t n = scene_.grain_count();
    if (frame.lid && !(std::isfinite(frame.lid->height) && std::isfinite(frame.lid->velocity))) {
        throw TrajectoryError(
            fmt::format("height or velocity of the lid is not finite at step {}", frame.step));
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (!(std::isfinite(frame.x[i]) && std::isfinite(frame.y[i]) &&
              std::isfinite(frame.vx[i]) && std::isfinite(frame.vy[i]))) {
            throw TrajectoryError(fmt::format(
                "position or velocity of grain {} is not finite at step {}", i, frame.step));
        }
        if (scene_.has_friction() && !std::isfinite(frame.omega[i])) {
            throw TrajectoryError(fmt::format(
                "angular velocity of grain {} is not finite at step {}", i, frame.step));
        }
        const double moved = std::hypot(frame.vx[i], frame.vy[i]) * scene_.dt;
        if (moved >= smallest_diameter_) {
            throw TrajectoryError(fmt::format(
                "grain {} moves {:.3g} diameters in one time step at step {}: dt = {:g} is too "
                "large for this state (contacts are jumped over)",
                i, moved / smallest_diameter_, frame.step, scene_.dt));
        }
    }
}

void FrameGuard::finish() const {
    if (expected_step_ <= scene_.steps) {
        throw TrajectoryError(fmt::format("trajectory ends before step {} ({} of {} frames)",
                                          expected_step_, frames_,
                                          scene_.steps / scene_.frame_every + 1));
    }
}

}  // namespace crossgrain::scene
