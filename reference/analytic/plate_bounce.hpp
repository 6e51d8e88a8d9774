// Bounce of a free grain on an elastic plate, without gravity, in closed form.
//
// The overlap is a harmonic oscillator, mu delta'' = -k delta, for half a cycle (reduced units):
//   t_c = pi sqrt(mu/k),  mu = m for a plate at rest, mu = m M/(m + M) for a free lid of mass M.
// Energy and momentum are conserved, so the relative velocity is reversed and with the velocity of
// the centre of mass V_c = (m v + M V)/(m + M)
//   v' = 2 V_c - v,  V' = 2 V_c - V.
#pragma once

#include <limits>

namespace crossgrain::analytic {

struct PlateBounce {
    double contact_time = 0;    ///< (t)
    double grain_velocity = 0;  ///< v' (l/t)
    double plate_velocity = 0;  ///< V' (l/t)
};

struct PlateImpact {
    double stiffness = 0;                                         ///< k (m/t^2), > 0
    double grain_mass = 0;                                        ///< m, > 0 and finite
    double plate_mass = std::numeric_limits<double>::infinity();  ///< M, > 0
    double grain_velocity = 0;                                    ///< v (l/t)
    double plate_velocity = 0;                                    ///< V (l/t)
};

/// Throws std::domain_error for parameters out of range. That grain and plate approach each other
/// is the caller's business: the result does not depend on which side the grain is.
[[nodiscard]] PlateBounce plate_bounce(const PlateImpact& impact);

}  // namespace crossgrain::analytic
