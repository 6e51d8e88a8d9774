// Largest stable time step of the integration schemes, for one mode and for the triangular lattice
// (packing_stability.hpp: for any packing of discs).
//
// One normal mode, x'' = -w^2 x - c x', with W = w^2 dt^2 and C = c dt. Each scheme multiplies its
// state by a matrix; the powers stay bounded while the roots z of its characteristic polynomial lie
// in the unit disc (Jury's conditions; Jury, J. Franklin Inst. 274, 304 (1962)).
//   half-step Verlet, semi-implicit Euler (the same map, seen half a step apart)
//     z^2 - (2 - C - W) z + (1 - C)               z = -1 first:  W + 2 C = 4
//   predicted Verlet: v* = v_n + a_n dt in the dashpot, so that with x = dt^2 z/(z - 1)^2 a and
//     v = dt (z + 1)/(2 (z - 1)) a  the equation for a gives
//     z^3 + (W + 3 C/2 - 2) z^2 + (1 - 2 C) z + C/2
//     z = -1 first:  W + 4 C = 4; the pair of complex roots needs 2 - C - C W/2 - C^2 > 0, which
//     below that limit is at least (1 - C)(2 - C) and C < 1
//   leap-frog with Crank-Nicolson damping
//     (1 + C/2) z^2 - (2 - W) z + (1 - C/2)       z = -1:  W = 4, whatever the damping
//   explicit Euler
//     z^2 - (2 - C) z + (1 - C + W)               W = C (complex), W - 2 C + 4 = 0 (z = -1)
//   Taguchi's Euler (chao-dyn/9405003, Eqs. 7 and 8)
//     z^2 - (2 - W/2 - C) z + (1 - C + W/2)       W = 2 C (complex), C = 2 (z = -1)
//   classical Runge-Kutta: |R(l dt)| = 1 for a root l of l^2 + c l + w^2, R the polynomial of
//     degree four of exp; undamped: w dt = 2 sqrt 2.
#pragma once

#include "reference/analytic/oblique_collision.hpp"
#include "reference/analytic/time_scheme.hpp"

#include <complex>
#include <optional>

namespace crossgrain::analytic {

/// g of the condition dt^2 w^2 + g dt c = 4 at which z = -1 leaves the unit disc first: 2
/// (half-step Verlet, semi-implicit Euler), 4 (predicted Verlet), 0 (Crank-Nicolson); nothing for
/// other schemes. With matrices instead of w^2 and c the largest eigenvalue takes the place of the
/// sum, for every state u has a w^2 = u'Ku and a c = u'Cu of its own, and they need not commute.
[[nodiscard]] std::optional<double> damping_weight(TimeScheme scheme);

/// Largest dt (t) for a mode of angular frequency `frequency` > 0 (1/t), damped at the rate
/// `damping_rate` >= 0 (1/t); 0 for a scheme that never is stable. Throws std::domain_error for
/// arguments out of range.
[[nodiscard]] double mode_time_step_limit(TimeScheme scheme, double frequency, double damping_rate);

/// What one step of dt multiplies u with, u' = mu u: R(mu dt) with R the polynomial of the scheme,
/// 1 + x (explicit Euler) or that of degree four of exp (Runge-Kutta). Throws std::domain_error for
/// another scheme.
[[nodiscard]] std::complex<double> growth_factor(TimeScheme scheme, std::complex<double> mu_dt);

/// Largest dt (t) for u' = mu u, mu not 0, in one of these two schemes: |R(mu dt)| <= 1.
[[nodiscard]] double eigenvalue_time_step_limit(TimeScheme scheme, std::complex<double> mu);

/// Largest dt (t) in the triangular lattice with all contacts closed (stability_limit.hpp): the
/// least over its modes, on a grid of wave vectors that holds the middle and the corner of the
/// zone's edge; at most 1e-4 too large between its points. Throws std::domain_error for arguments
/// out of range.
[[nodiscard]] double lattice_time_step_limit(TimeScheme scheme, double stiffness, double damping,
                                             double mass, Damping damping_acts_on);

}  // namespace crossgrain::analytic
