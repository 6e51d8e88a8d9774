// The two Euler schemes, of first order; one force evaluation per step, at its start.
//   explicit:       x_{n+1} = x_n + v_n dt,      v_{n+1} = v_n + a(x_n, v_n, t_n) dt
//   semi-implicit:  v_{n+1} = v_n + a(x_n, v_n, t_n) dt,      x_{n+1} = x_n + v_{n+1} dt
// The explicit one feeds every oscillation omega with the rate omega^2 dt/2; the semi-implicit one
// is symplectic without dashpots (Hairer, Lubich & Wanner, Geometric Numerical Integration, I.1).
#pragma once

#include "native/dem/scheme.hpp"

namespace crossgrain::dem {

class ExplicitEuler {
  public:
    void start(Accelerated auto&, Motion&, double) {}

    void step(Accelerated auto& system, Motion& m, const TimeStep& t) {
        system.accelerations(m.q, m.v, t.start, m.a);
        add_scaled(m.q, t.dt, m.v);
        add_scaled(m.v, t.dt, m.a);
    }
};

class SemiImplicitEuler {
  public:
    void start(Accelerated auto&, Motion&, double) {}

    void step(Accelerated auto& system, Motion& m, const TimeStep& t) {
        system.accelerations(m.q, m.v, t.start, m.a);
        add_scaled(m.v, t.dt, m.a);
        add_scaled(m.q, t.dt, m.v);
    }
};

}  // namespace crossgrain::dem
