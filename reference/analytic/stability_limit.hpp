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
// At the middle M of an edge of the Brillouin zone: w^2 = 6 k/m (the largest there is), c = 8 eta/m
// (full) or 6 eta/m (normal). At its corner K: w^2 = 4.5 k/m, c = 9 eta/m (full, the largest there
// is). The limit is the smaller of both; with full damping of M, w^2 dt^2 + 16 (eta/m) dt = 4.
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
[[nodiscard]] double lattice_time_step_limit(double stiffness, double damping, double mass,
                                             Damping damping_acts_on);

}  // namespace crossgrain::analytic
