// Leap-frog with Crank-Nicolson damping: the dashpots see the mean of the half-step velocities
// before and after,
//   v_{n+1/2} - v_{n-1/2} = dt a(x_n, v_n, t_n),   v_n = (v_{n-1/2} + v_{n+1/2})/2,
//   x_{n+1} - x_n = dt v_{n+1/2}.
// Second order, and the dashpots cannot make it unstable. The equation for v_n is
//   v_n = v_{n-1/2} + (dt/2) a(x_n, v_n, t_n);
// it is linear with all contacts of a grain coupled, and is solved by iteration: each round gains
// a factor (dt/2) lambda with lambda <= 12 eta/m, the largest rate of the dashpots of six contacts.
#pragma once

#include "native/base/errors.hpp"
#include "native/dem/scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain::dem {

class LeapfrogCrankNicolson {
  public:
    void start(Accelerated auto& system, Motion& m, double t) {
        system.accelerations(m.q, m.v, t, m.a);
    }

    void step(Accelerated auto& system, Motion& m, const TimeStep& t) {
        const double half = t.dt / 2;
        add_scaled(m.v, half, m.a);
        add_scaled(m.q, t.dt, m.v);
        half_step_ = m.v;
        add_scaled(m.v, half, m.a);  // the first guess of v_{n+1}
        for (int round = 0; round < most_rounds; ++round) {
            system.accelerations(m.q, m.v, t.end, m.a);
            if (improve(m, half)) return;
        }
        throw TrajectoryError(
            fmt::format("the implicit velocities at t = {:g} do not converge within {} rounds; "
                        "a smaller dt would help",
                        t.end, most_rounds));
    }

  private:
    static constexpr int most_rounds = 100;
    /// Of a velocity of order 1: a few roundings.
    static constexpr double converged = 1e-14;

    /// v = v_{n+1/2} + (dt/2) a; whether that has changed nothing any more.
    bool improve(Motion& m, double half) const {
        double largest_change = 0, largest = 1;
        for (std::size_t i = 0; i < m.v.size(); ++i) {
            const double v = half_step_[i] + half * m.a[i];
            largest_change = std::max(largest_change, std::abs(v - m.v[i]));
            largest = std::max(largest, std::abs(v));
            m.v[i] = v;
        }
        return largest_change <= converged * largest;
    }

    std::vector<double> half_step_;
};

}  // namespace crossgrain::dem
