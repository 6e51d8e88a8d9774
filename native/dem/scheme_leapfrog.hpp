// Leap-frog with Crank-Nicolson damping: the dashpots see the mean of the half-step velocities
// before and after,
//   v_{n+1/2} - v_{n-1/2} = dt a(x_n, v_n, t_n),   v_n = (v_{n-1/2} + v_{n+1/2})/2,
//   x_{n+1} - x_n = dt v_{n+1/2}.
// Second order, and the dashpots cannot make it unstable. The equation for v_n is
//   v_n = v_{n-1/2} + (dt/2) a(x_n, v_n, t_n),
// whose matrix 1 + (dt/2) C couples all contacts of a grain. It is solved by Richardson iteration:
// no rate of C exceeds lambda = 12 eta/m, that of the dashpots of six contacts, so that with the
// relaxation 2/(2 + rho), rho = (dt/2) lambda, each round gains a factor rho/(2 + rho) < 1 at any
// dt.
#pragma once

#include "native/base/errors.hpp"
#include "native/dem/scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain::dem {

class LeapfrogCrankNicolson {
  public:
    /// The systems it integrates also tell their largest_dashpot_rate(), lambda.
    void start(Accelerated auto& system, Motion& m, double t) {
        largest_rate_ = system.largest_dashpot_rate();
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
    /// Enough for rho = 5, where dt is far above the limit that the springs set.
    static constexpr int most_rounds = 100;
    /// Of a velocity of order 1: a few roundings.
    static constexpr double converged = 1e-14;

    /// v towards v_{n+1/2} + (dt/2) a; whether v was that already.
    bool improve(Motion& m, double half) const {
        const double relaxation = 2 / (2 + half * largest_rate_);
        double largest_residual = 0, largest = 1;
        for (std::size_t i = 0; i < m.v.size(); ++i) {
            const double residual = half_step_[i] + half * m.a[i] - m.v[i];
            largest_residual = std::max(largest_residual, std::abs(residual));
            m.v[i] += relaxation * residual;
            largest = std::max(largest, std::abs(m.v[i]));
        }
        return largest_residual <= converged * largest;
    }

    double largest_rate_ = 0;
    std::vector<double> half_step_;
};

}  // namespace crossgrain::dem
