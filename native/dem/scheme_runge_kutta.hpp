// The classical Runge-Kutta scheme of fourth order (Kutta 1901) for x' = v, v' = a(x, v, t). Four
// force evaluations per step. Contacts that open and close within a step cut its order to that of
// the jump: 1 where a dashpot acts at once, 2 for a spring.
#pragma once

#include "native/dem/scheme.hpp"

namespace crossgrain::dem {

class RungeKutta4 {
  public:
    void start(Accelerated auto&, Motion&, double) {}

    void step(Accelerated auto& system, Motion& m, const TimeStep& t) {
        const double half = t.dt / 2;
        q_ = q_sum_ = m.q;
        v_ = v_sum_ = m.v;
        const auto stage = [&](double time, double weight, double to_next) {
            system.accelerations(q_, v_, time, m.a);
            add_scaled(q_sum_, weight * t.dt, v_);
            add_scaled(v_sum_, weight * t.dt, m.a);
            for (std::size_t i = 0; i < q_.size(); ++i) {
                q_[i] = m.q[i] + to_next * v_[i];
                v_[i] = m.v[i] + to_next * m.a[i];
            }
        };
        stage(t.start, 1.0 / 6, half);
        stage(t.start + half, 1.0 / 3, half);
        stage(t.start + half, 1.0 / 3, t.dt);
        stage(t.end, 1.0 / 6, 0.0);
        m.q.swap(q_sum_);
        m.v.swap(v_sum_);
    }

  private:
    std::vector<double> q_, v_;          ///< of the stage
    std::vector<double> q_sum_, v_sum_;  ///< x_n and v_n plus the weighted slopes
};

}  // namespace crossgrain::dem
