// Distinct elements in two dimensions: advances a State by whole time steps.
// The order of a time step (both schemes are velocity Verlet, kick-drift-kick):
//   1. v_{n+1/2} = v_n + a_n dt/2
//   2. x_{n+1}   = x_n + v_{n+1/2} dt
//   3. neighbour list, if a grain has moved by more than half the skin
//   4. a_{n+1}   = F(x_{n+1}, v*, t_{n+1})/m - g
//      half step:  v* = v_{n+1/2}                (what LAMMPS, LIGGGHTS and YADE's leap-frog do)
//      predicted:  v* = v_{n+1/2} + a_n dt/2     (second order in the dashpot)
//   5. v_{n+1}   = v_{n+1/2} + a_{n+1} dt/2
#pragma once

#include "native/dem/system.hpp"

#include <cstdint>
#include <memory>

namespace crossgrain::dem {

class Engine {
  public:
    /// Resolves law and scheme once; the step loop holds nothing the scene does not need.
    Engine(const Parameters& parameters, State state);
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Advances by `steps` time steps, >= 0.
    /// Throws TrajectoryError when a position is no longer finite.
    void advance(std::int64_t steps);

    [[nodiscard]] const State& state() const noexcept;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace crossgrain::dem
