// Largest stable time step of the integration schemes in a packing, from its own matrices.
//
// A packing at equilibrium has u'' = -K u - C u' (closed_packing.hpp); a time step is stable while
// the one-step map (step_map.hpp) has no eigenvalue outside of the unit disc. The limit is found
//   from the extreme mode, where the first eigenvalue to leave the disc is z = -1 (the Verlet
//     family: g of scheme_stability.hpp): the largest eigenvalue of dt^2 K + g dt C reaches 4,
//     whether K and C commute or not. The mode u of one dt gives the next, the root of
//     dt^2 u'Ku + g dt u'Cu = 4, which falls monotonically;
//   mode by mode, where K and C commute (periodic lattices; springs and dashpots along the same
//     bonds): the least of mode_time_step_limit;
//   from the eigenvalues of the equation of motion (native/numerics/damped_modes.hpp), where they
//     do not commute: plates have springs but no dashpots. Explicit Euler and Runge-Kutta multiply
//     the state of an eigenvalue mu with a polynomial in mu dt; Taguchi's Euler is explicit Euler
//     with the damping C + dt K/2.
#pragma once

#include "reference/analytic/closed_packing.hpp"
#include "reference/analytic/time_scheme.hpp"

#include <complex>
#include <optional>

namespace crossgrain::analytic {

struct PackingLimit {
    double dt = 0;  ///< largest stable time step (t); 0 for a scheme that never is stable
    std::complex<double> eigenvalue;  ///< of the one-step map, on the unit circle
    double residual = 0;              ///< |M s - z s|/(|z| |s|) of that eigenvalue and its state s
};

struct PackingFrequency {
    double value = 0;     ///< (1/t)
    double residual = 0;  ///< of the eigenpair of K
};

/// Largest angular frequency of the contacts there are; 0 without any.
[[nodiscard]] PackingFrequency largest_packing_frequency(const ClosedPacking& packing);

/// Nothing for a packing without contacts. Throws what packing_matrices throws, and
/// std::runtime_error if an eigenpair does not converge.
[[nodiscard]] std::optional<PackingLimit> packing_time_step_limit(TimeScheme scheme,
                                                                  const ClosedPacking& packing);

}  // namespace crossgrain::analytic
