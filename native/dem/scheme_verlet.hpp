// Velocity Verlet, kick-drift-kick (Swope, Andersen, Berens & Wilson, J. Chem. Phys. 76, 637
// (1982)), with two choices of the velocity v* that the dashpots see:
//   1. v_{n+1/2} = v_n + a_n dt/2
//   2. x_{n+1}   = x_n + v_{n+1/2} dt
//   3. a_{n+1}   = a(x_{n+1}, v*, t_{n+1})
//      half step:  v* = v_{n+1/2}                (what LAMMPS, LIGGGHTS and YADE's leap-frog do)
//      predicted:  v* = v_{n+1/2} + a_n dt/2     (second order in the dashpot)
//   4. v_{n+1}   = v_{n+1/2} + a_{n+1} dt/2
// One force evaluation per step.
#pragma once

#include "native/dem/scheme.hpp"

namespace crossgrain::dem {

enum class DashpotVelocity { half_step, predicted };

template <DashpotVelocity dashpot>
class Verlet {
  public:
    void start(Accelerated auto& system, Motion& m, double t) {
        system.accelerations(m.q, m.v, t, m.a);
    }

    void step(Accelerated auto& system, Motion& m, const TimeStep& t) {
        const double half = t.dt / 2;
        add_scaled(m.v, half, m.a);
        add_scaled(m.q, t.dt, m.v);
        if constexpr (dashpot == DashpotVelocity::predicted) {
            predicted_ = m.v;
            add_scaled(predicted_, half, m.a);
            system.accelerations(m.q, predicted_, t.end, m.a);
        } else {
            system.accelerations(m.q, m.v, t.end, m.a);
        }
        add_scaled(m.v, half, m.a);
    }

  private:
    std::vector<double> predicted_;
};

}  // namespace crossgrain::dem
