#include "reference/analytic/stability_limit.hpp"

#include "reference/analytic/parameter_check.hpp"

#include <cmath>

namespace crossgrain::analytic {
namespace {

// The real root of s^3 + p s = q, p > 0, by hyperbolic functions; dt = s^2.
double limit_between_middle_and_corner(double stiffness, double damping, double mass) {
    const double p = 8 * damping / stiffness;
    const double q = 8.0 / 3 * std::sqrt(2 * damping * mass) / stiffness;
    const double unit = 2 * std::sqrt(p / 3);
    const double s = unit * std::sinh(std::asinh(4 * q / (unit * unit * unit)) / 3);
    return s * s;
}

}  // namespace

double half_step_verlet_limit(double frequency, double damping_rate) {
    require_positive("frequency", frequency);
    require_not_negative("damping rate", damping_rate);
    // The root of w^2 dt^2 + 2 c dt = 4 in the form without cancellation.
    return 4 / (damping_rate + std::sqrt(damping_rate * damping_rate + 4 * frequency * frequency));
}

double largest_lattice_frequency(double stiffness, double mass) {
    require_positive("stiffness", stiffness);
    require_positive("mass", mass);
    return std::sqrt(6 * stiffness / mass);
}

double lattice_time_step_limit(double stiffness, double damping, double mass,
                               Damping damping_acts_on) {
    const double at_edge = largest_lattice_frequency(stiffness, mass);
    require_not_negative("damping", damping);
    // C = (eta/k) D: the mode of largest frequency is also the most damped one.
    if (damping_acts_on == Damping::normal_only) {
        return half_step_verlet_limit(at_edge, 6 * damping / mass);
    }
    if (damping == 0) return half_step_verlet_limit(at_edge, 0);
    const double middle = half_step_verlet_limit(at_edge, 8 * damping / mass);
    const double between = limit_between_middle_and_corner(stiffness, damping, mass);
    return stiffness * between < 8.0 / 3 * damping ? between : middle;
}

}  // namespace crossgrain::analytic
