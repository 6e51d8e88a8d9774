// One instant of a trajectory. Frames are the only thing that comes back across the boundary of a
// code; they are streamed and never kept.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace crossgrain::scene {

struct LidState {
    double height = 0;
    double velocity = 0;
};

/// Views are valid during the call only. All spans have shape (grains), ordered as in the scene.
struct Frame {
    std::int64_t step = 0;
    double time = 0;                 ///< step * dt
    std::span<const double> x, y;    ///< unwrapped positions
    std::span<const double> vx, vy;  ///< velocities at this time (not at a half step)
    std::optional<LidState> lid;     ///< present if the scene has a free lid
    std::span<const double> omega;   ///< angular velocities; empty unless the scene has friction
};

using FrameSink = std::function<void(const Frame&)>;

}  // namespace crossgrain::scene
