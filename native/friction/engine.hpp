// Rotating discs with friction: advances a State by whole time steps. A step is velocity Verlet
// with the half-step velocities in all forces that depend on velocity:
//   v += a dt/2, omega += alpha dt/2; x += v dt; a, alpha from (x, v, omega); v += a dt/2, ...
// as LAMMPS and LIGGGHTS do it, and YADE's leap-frog half a step apart.
#pragma once

#include "native/friction/system.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace crossgrain::friction {

/// What a run has taken so far.
struct Effort {
    std::string kernel;                  ///< "scalar" or e.g. "simd (AVX3)"
    std::int64_t force_evaluations = 0;  ///< of all grains together
    std::int64_t neighbour_builds = 0;
    double pairs = 0;  ///< in the present neighbour list, per mobile grain
};

class Engine {
  public:
    /// Resolves kernel and law once. Contacts of the initial state start with relaxed springs.
    /// Throws std::invalid_argument when a parameter is out of its range, a period is not above two
    /// diameters of the largest grain, or the simd kernel is asked for where there are no vectors.
    Engine(const Parameters& parameters, State state);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Advances by `steps` time steps, >= 0; a run cut in pieces is the same bit for bit.
    /// Throws TrajectoryError when a position is no longer finite.
    void advance(std::int64_t steps);

    /// The grains in the order in which they were given, at time state().step * dt.
    [[nodiscard]] const State& state() const;
    [[nodiscard]] Effort effort() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace crossgrain::friction
