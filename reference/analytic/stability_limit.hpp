// Largest stable time step of the Verlet scheme in a triangular lattice of spring-dashpot contacts.
//
// One normal mode, x'' = -w^2 x - c x'. Kick-drift-kick with the dashpot evaluated at the half-step
// velocity is, seen at half steps,
//   u_{n+1/2} = u_{n-1/2} - dt (w^2 x_n + c u_{n-1/2}),   x_{n+1} = x_n + dt u_{n+1/2},
// whose amplification factors obey  z^2 - (2 - c dt - w^2 dt^2) z + (1 - c dt) = 0. The first to
// leave the unit circle is the real one at z = -1:
//   w^2 dt^2 + 2 c dt = 4,   dt = (-c + sqrt(c^2 + 4 w^2))/w^2;   c = 0: dt = 2/w.
//
// Modes of the lattice with contacts at their rest length: for wave vector q, bonds a_j (six),
//   D(q) = (k/m)  sum_j (1 - cos q.a_j) n_j n_j^T          (stiffness)
//   C(q) = (eta/m) sum_j (1 - cos q.a_j) 1    full vector,  (eta/k) D(q)   normal only.
// Both grow towards the edge of the Brillouin zone, and on the edge, from its middle M (u = 1) to a
// corner K (u = 1/2), the stiffer branch has with unit bond length and u = cos(q_x/2)
//   w^2 = 3 (1 + u) k/m,   c = 4 (1 + u)(2 - u) eta/m (full),   (eta/k) w^2 (normal only).
// Normal only, or little damping: M is the first to go, w^2 = 6 k/m (the largest there is), with
//   w^2 dt^2 + 16 (eta/m) dt = 4 (full),   w^2 dt^2 + 12 (eta/m) dt = 4 (normal only).
// More full damping: with a = 3 (k/m) dt^2, b = 8 (eta/m) dt the condition for u is
// (1 + u)(a + b (2 - u)) = 4; its left side is largest at u = 1/2 + a/(2 b), which is below 1 if
// k dt < (8/3) eta, and there (a + 3 b)^2 = 16 b, a cubic for s = sqrt(dt):
//   s^3 + 8 (eta/k) s = (8/3) sqrt(2 eta m)/k.
// The limit at M alone is 1 % too large for e = 0.5, and right for e = 0.8, at equal t_col.
// Contacts that open lower all frequencies, so that a bed may run beyond the limit for a while;
// a stable time step is not an accurate one.
#pragma once

#include "reference/analytic/oblique_collision.hpp"

namespace crossgrain::analytic {

/// Largest dt (t) for one mode of angular frequency w = `frequency` > 0 (1/t) damped at the rate
/// c = `damping_rate` >= 0 (1/t). Throws std::domain_error for arguments out of range.
[[nodiscard]] double half_step_verlet_limit(double frequency, double damping_rate);

/// Largest angular frequency of the triangular lattice, sqrt(6 k/m) (1/t).
[[nodiscard]] double largest_lattice_frequency(double stiffness, double mass);

/// Largest dt (t) of the half-step Verlet scheme in the lattice; damping 0 gives 2/omega_max.
/// Throws std::domain_error for arguments out of range.
[[nodiscard]] double lattice_time_step_limit(double stiffness, double damping, double mass,
                                             Damping damping_acts_on);

}  // namespace crossgrain::analytic
