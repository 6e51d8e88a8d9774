#include "reference/analytic/oblique_collision.hpp"

#include "reference/analytic/parameter_check.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace crossgrain::analytic {
namespace {

namespace odeint = boost::numeric::odeint;

// (x, y, vx, vy) of the relative motion. A vector because the steppers copy their buffers before
// they are first written, which a vector allows.
using State = std::vector<double>;
using Stepper = odeint::runge_kutta_fehlberg78<State>;

struct NormalMotion {
    double distance = 0;
    double nx = 0, ny = 0;
    double speed = 0;  // v_n, > 0 when parting
};

NormalMotion normal_motion(const State& s) {
    const double r = std::hypot(s[0], s[1]);
    const double nx = s[0] / r, ny = s[1] / r;
    return {r, nx, ny, s[2] * nx + s[3] * ny};
}

double normal_force(const ObliqueContact& c, const NormalMotion& n) {
    return c.stiffness * (c.diameter - n.distance) - c.damping * n.speed;
}

// The force of one phase of the contact; smooth beyond the end of the phase, so that a trial step
// may overrun it.
struct RelativeMotion {
    const ObliqueContact& contact;
    bool normal_acts;
    bool tangential_acts;

    void operator()(const State& s, State& rate, double /*t*/) const {
        const NormalMotion n = normal_motion(s);
        const double along = normal_acts ? normal_force(contact, n) : 0.0;
        const double drag = tangential_acts ? contact.damping : 0.0;
        rate[0] = s[2];
        rate[1] = s[3];
        rate[2] = (along * n.nx - drag * (s[2] - n.speed * n.nx)) / contact.reduced_mass;
        rate[3] = (along * n.ny - drag * (s[3] - n.speed * n.ny)) / contact.reduced_mass;
    }
};

// Advances until `remaining(state)` falls through zero.
class PhaseIntegrator {
  public:
    explicit PhaseIntegrator(double time_scale)
        : dt_(time_scale / 1000), longest_(time_scale / 20), limit_(100 * time_scale) {}

    double time = 0;

    void advance(const RelativeMotion& motion, State& state,
                 const std::function<double(const State&)>& remaining) {
        auto controlled = odeint::make_controlled(1e-13, 1e-13, Stepper{});
        while (time < limit_) {
            State next = state;
            double next_time = time;
            dt_ = std::min(dt_, longest_);
            if (controlled.try_step(motion, next, next_time, dt_) == odeint::fail) continue;
            if (remaining(next) <= 0) {
                finish_step(motion, state, next_time - time, remaining);
                return;
            }
            state = next;
            time = next_time;
        }
        throw std::domain_error("the grains stick: they have not parted after 100 undamped half "
                                "periods of the contact");
    }

  private:
    // One step of the length at which `remaining` vanishes; it is as accurate as the accepted step.
    void finish_step(const RelativeMotion& motion, State& state, double step,
                     const std::function<double(const State&)>& remaining) {
        Stepper stepper;
        const auto after = [&](double h) {
            State trial = state;
            stepper.do_step(motion, trial, time, h);
            return trial;
        };
        const double at_end = remaining(after(step));
        double root = step;
        if (at_end < 0) {
            std::uintmax_t iterations = 200;
            const auto bracket = boost::math::tools::toms748_solve(
                [&](double h) { return h == 0 ? remaining(state) : remaining(after(h)); }, 0.0,
                step, remaining(state), at_end, boost::math::tools::eps_tolerance<double>(52),
                iterations);
            root = (bracket.first + bracket.second) / 2;
        }
        state = after(root);
        time += root;
    }

    double dt_;
    double longest_;
    double limit_;
};

void check(const ObliqueContact& c, const ObliqueImpact& impact) {
    require_positive("stiffness", c.stiffness);
    require_not_negative("damping", c.damping);
    require_positive("reduced mass", c.reduced_mass);
    require_positive("diameter", c.diameter);
    require_positive("speed", impact.speed);
    require_not_negative("impact parameter", impact.impact_parameter);
    if (impact.impact_parameter >= c.diameter) {
        throw std::domain_error(fmt::format("impact parameter must be < d = {}, got {}", c.diameter,
                                            impact.impact_parameter));
    }
    // The deepest overlap of a head-on collision is at most v sqrt(mu/k).
    const double deepest = impact.speed * std::sqrt(c.reduced_mass / c.stiffness);
    if (deepest >= c.diameter) {
        throw std::domain_error(fmt::format(
            "speed {} is too large for the contact: the overlap may reach {}, d is {}, and the "
            "normal is lost where the centres meet",
            impact.speed, deepest, c.diameter));
    }
}

}  // namespace

ObliqueCollision oblique_collision(const ObliqueContact& contact, const ObliqueImpact& impact) {
    check(contact, impact);
    const double d = contact.diameter, b = impact.impact_parameter, v = impact.speed;
    // The grain comes along +x at y = b and touches at x = -sqrt(d^2 - b^2).
    const State initial = {-std::sqrt((d - b) * (d + b)), b, v, 0.0};
    State state = initial;

    const bool full = contact.damping_acts_on == Damping::full_vector;
    PhaseIntegrator phase(std::numbers::pi * std::sqrt(contact.reduced_mass / contact.stiffness));
    const auto overlap = [d](const State& s) { return d - std::hypot(s[0], s[1]); };
    // Grains start at r = d moving inwards: only an outward crossing ends the contact.
    const auto until_parted = [&](const State& s) {
        return normal_motion(s).speed <= 0 ? 1.0 : overlap(s);
    };
    double force_time = 0;
    if (contact.clipping == Clipping::none || contact.damping == 0) {
        phase.advance({contact, true, full}, state, until_parted);
        force_time = phase.time;
    } else {
        phase.advance({contact, true, full}, state,
                      [&](const State& s) { return normal_force(contact, normal_motion(s)); });
        force_time = phase.time;
        const bool keeps_drag = full && contact.clipping == Clipping::normal_only;
        phase.advance({contact, false, keeps_drag}, state, overlap);
    }

    const double out = std::hypot(state[2], state[3]);
    const double cross_in = initial[0] * initial[3] - initial[1] * initial[2];
    const double cross_out = state[0] * state[3] - state[1] * state[2];
    return {.restitution = -normal_motion(state).speed / normal_motion(initial).speed,
            .contact_time = phase.time,
            .force_time = force_time,
            .angular_momentum_ratio =
                b == 0 ? std::numeric_limits<double>::quiet_NaN() : cross_out / cross_in,
            .speed_ratio = out / v,
            .deflection = std::abs(std::atan2(state[3], state[2])),
            .dissipated = contact.reduced_mass / 2 * (v - out) * (v + out)};
}

}  // namespace crossgrain::analytic
