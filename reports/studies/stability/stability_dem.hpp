// Where the integrators of distinct elements stop working: largest stable time steps by bisection,
// against the closed forms, and the error of the energy balance below them.
#pragma once

#include "adapters/run/settings.hpp"
#include "adapters/run/store/store.hpp"
#include "cases/catalog/case.hpp"
#include "reports/studies/stability/stability.hpp"

#include <stop_token>

namespace crossgrain::studies {

/// Whether stability can be tried out on a case of grains: a bed or a lattice with a period along
/// x.
[[nodiscard]] bool has_residuals(const catalog::Case& the_case, std::uint64_t seed);

/// Thresholds of every code in every integrator it has, for the contact law of the case with its
/// own restitution and others at equal contact time, for both directions of the damping:
///   closed contacts: a triangular lattice, compressed by 1e-4 d so that no contact ever opens,
///     periodic both ways; with a prescribed lid it lies between the plates at rest instead. The
///     time step fails if a perturbation of 1e-6 grows. Theory: the one-step map of the packing
///     itself (reference/analytic/packing_stability.hpp), to 1 %; not compared where the engine's
///     solver for Crank-Nicolson damping gives up before the scheme does, nor where an
///     Euler scheme turns unstable too slowly for a trial of 6000 steps.
///   open contacts: the same lattice without compression, with velocities of 0.1 as in the lattice
///     cases; no theory, and only in the first code that has the integrator.
/// They are found side by side and kept in the store: a call that was stopped goes on where it was.
/// Points, unless a map is asked for: the first variant of the case itself in a quarter of its
/// width over three periods of the drive, energy residual against dt for every integrator; `ok`
/// below 1 %, `energy gain`, `inaccurate` (a loss), `blow-up`.
///
/// Ends early when stopped. Throws CaseError for a case whose scene cannot be read, and
/// std::invalid_argument for one that has_residuals() denies, unless a map is asked for.
[[nodiscard]] StabilityReport stability_dem(const catalog::Case& the_case,
                                            const run::Settings& settings, store::Store& store,
                                            std::stop_token stop);

/// Largest stable time steps in a dense packing for every law and integrator of a map of grains
/// that has the axis "dt"; none for another map.
[[nodiscard]] std::vector<TheoryLine> theory_lines(const catalog::Case& map, std::uint64_t seed);

}  // namespace crossgrain::studies
