// Size, duration and sampling of a run that yields GasFrames: all that an estimator needs to know.
#pragma once

#include <cstdint>

namespace crossgrain::scene {

/// What a frame holds.
struct GasFields {
    bool count = true;      ///< particles per bin
    bool rests = false;     ///< particles at rest per bin
    bool momentum = false;  ///< downward momentum per bin, in half lattice velocities
};

/// Frames are taken at steps burn_in, burn_in + every, ..., burn_in + steps: steps / every + 1 of
/// them. Reduced units: one site, one time step.
struct GasSampling {
    int length = 0;            ///< L, sites along the pipe, > 0, multiple of `bin`
    int width = 0;             ///< W, sites across, >= 3
    bool periodic = true;      ///< along the pipe
    int bin = 1;               ///< length of a bin, in sites
    int replicas = 64;         ///< ensemble of this run, 1 to 512
    std::int64_t burn_in = 0;  ///< steps before the first frame, >= 0
    std::int64_t steps = 0;    ///< steps after burn_in, > 0, multiple of `every`
    std::int64_t every = 1;    ///< steps between frames, > 0
    GasFields fields;

    [[nodiscard]] int bins() const noexcept { return length / bin; }
    [[nodiscard]] std::int64_t frames() const noexcept { return steps / every + 1; }
};

}  // namespace crossgrain::scene
