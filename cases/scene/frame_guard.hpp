// Every frame, of every code, passes here before anybody measures it. A trajectory that cannot be
// what the scene asked for stops the run instead of becoming a number.
#pragma once

#include "cases/scene/frame.hpp"
#include "cases/scene/motion_guard.hpp"
#include "cases/scene/scene.hpp"

#include <cstdint>

namespace crossgrain::scene {

/// Checks, in this order: the step is the next one of the schedule (no gap, no overlap), the number
/// of grains, the lid's presence, angular velocities where there is friction, finiteness, and that
/// no grain moves by a diameter (of the smallest) or more within one time step (contacts would be
/// jumped over: dt is too large for this state); then what MotionGuard checks.
class FrameGuard {
  public:
    FrameGuard(const Scene& scene, FrameSink next);

    /// Passes the frame on. Throws TrajectoryError with the reason.
    void operator()(const Frame& frame);

    /// Throws TrajectoryError unless the last frame of the schedule has passed.
    void finish() const;

    [[nodiscard]] std::int64_t frames_passed() const noexcept { return frames_; }

  private:
    void check_schedule(const Frame& frame) const;
    void check_shape(const Frame& frame) const;
    void check_values(const Frame& frame) const;

    const Scene& scene_;
    FrameSink next_;
    double smallest_diameter_;
    MotionGuard motion_;
    std::int64_t expected_step_ = 0;
    std::int64_t frames_ = 0;
};

}  // namespace crossgrain::scene
