#include "reference/analytic/plate_bounce.hpp"

#include "reference/analytic/normal_collision.hpp"
#include "reference/analytic/parameter_check.hpp"

#include <cmath>
#include <numbers>

namespace crossgrain::analytic {

PlateBounce plate_bounce(const PlateImpact& impact) {
    require_positive("stiffness", impact.stiffness);
    require_positive("grain mass", impact.grain_mass);
    const double mu = reduced_mass(impact.grain_mass, impact.plate_mass);
    // mu/m and mu/M instead of masses, so that an infinite M needs no case of its own.
    const double of_grain = mu / impact.plate_mass, of_plate = mu / impact.grain_mass;
    const double centre = of_grain * impact.grain_velocity + of_plate * impact.plate_velocity;
    return {.contact_time = std::numbers::pi * std::sqrt(mu / impact.stiffness),
            .grain_velocity = 2 * centre - impact.grain_velocity,
            .plate_velocity = 2 * centre - impact.plate_velocity};
}

}  // namespace crossgrain::analytic
