// The scheme of Taguchi's Appendix A, at fixed step and with his choice of the step:
//   x(t + dt) = x + v dt + a dt^2/2                                              (Eq. 7)
//   v(t + dt) = v + a dt                                                         (Eq. 8)
// First order; it feeds an oscillation omega with the rate omega^2 dt/4. The step is the shortest
// time in which any coordinate of a grain moves by alpha = 0.005 d                 (Eqs. 9, 10).
// Where the acceleration opposes the velocity Eqs. 9 and 10 have no real root for alpha ahead; the
// grain then turns back and reaches alpha behind: the correct root is the smaller positive one of
//   |v dt + a dt^2/2| = alpha.
// Grains at rest would make the step infinite: it is never longer than TimeStep::dt.
#pragma once

#include "native/dem/scheme.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossgrain::dem {

/// Smallest dt > 0 with |v dt + a dt^2/2| = alpha, alpha > 0; infinite if v = a = 0.
[[nodiscard]] inline double time_to_move(double alpha, double v, double a) {
    // Turned so that v >= 0; each root is written without cancellation.
    if (std::signbit(v)) a = -a;
    v = std::abs(v);
    const double ahead = v * v + 2 * a * alpha;
    if (ahead >= 0) return 2 * alpha / (v + std::sqrt(ahead));
    return (v + std::sqrt(v * v - 2 * a * alpha)) / -a;
}

class TaguchiEuler {
  public:
    void start(Accelerated auto&, Motion&, double) {}

    void step(Accelerated auto& system, Motion& m, const TimeStep& t) {
        system.accelerations(m.q, m.v, t.start, m.a);
        move(m, t.dt);
    }

    static void move(Motion& m, double dt) {
        for (std::size_t i = 0; i < m.q.size(); ++i) {
            m.q[i] += m.v[i] * dt + m.a[i] * (dt * dt / 2);
            m.v[i] += m.a[i] * dt;
        }
    }
};

class TaguchiAdaptiveEuler {
  public:
    /// The systems it integrates also tell the grains' diameter().
    void start(Accelerated auto& system, Motion&, double) { alpha_ = 0.005 * system.diameter(); }

    void step(Accelerated auto& system, Motion& m, const TimeStep& t) {
        double done = 0;
        while (done < t.dt) {
            system.accelerations(m.q, m.v, t.start + done, m.a);
            const double left = t.dt - done;
            const double sub_step = std::min(left, shortest_time(m));
            TaguchiEuler::move(m, sub_step);
            done = sub_step == left ? t.dt : done + sub_step;
        }
    }

  private:
    [[nodiscard]] double shortest_time(const Motion& m) const {
        double shortest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + 1 < m.q.size(); ++i)  // the lid is no grain
            shortest = std::min(shortest, time_to_move(alpha_, m.v[i], m.a[i]));
        return shortest;
    }

    double alpha_ = 0;
};

}  // namespace crossgrain::dem
