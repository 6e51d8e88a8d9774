// What the recipes of initial states share: room for grains, random velocities, spins, places and
// sizes, all pure functions of the scene's seed.
#pragma once

#include "cases/scene/initial_state.hpp"

#include <cstddef>

namespace crossgrain::scene {

/// A number of grains that was computed. Throws std::invalid_argument for more than most_grains,
/// before they are made; `what` needs them, e.g. "the walls".
[[nodiscard]] std::size_t grains_for(double count, const char* what);

/// n grains at the origin, at rest.
void resize(InitialState& state, std::size_t n);

/// Distance that an approach at `speed` covers until object k of `count` touches.
[[nodiscard]] double gap_of(std::size_t k, std::size_t count, double lead_steps, double speed,
                            double dt);

/// Gaussian velocities of standard deviation `spread` per component, their mean removed.
void thermalise(Scene& scene, double spread);

/// Gaussian angular velocities of standard deviation `spread`; leaves none when it is 0.
void draw_spins(Scene& scene, double spread);

/// Moves grain i by less than `reach` in a random direction.
void jitter(Scene& scene, std::size_t i, double reach);

/// Diameters and masses of all grains there are; leaves them alike when the spread is 0.
void draw_sizes(Scene& scene, const SizeSpread& sizes);

/// Appends a grain of the nominal size that never moves.
void add_frozen(Scene& scene, double x, double y);

/// Mass of a grain of diameter ratio * d.
[[nodiscard]] double mass_of(const Grains& grains, double ratio, double exponent);

}  // namespace crossgrain::scene
