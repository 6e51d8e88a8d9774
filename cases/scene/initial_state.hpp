// Initial states, generated once, exactly, for every code: positions and velocities at t = 0 with
// nothing in contact, so that each code can start in its own convention without an approximation.
#pragma once

#include "cases/scene/scene.hpp"

#include <cstdint>
#include <variant>

namespace crossgrain::scene {

/// Which elastic plate a `Bounces` state is thrown at.
enum class Target { bottom, lid };

/// Isolated pairs that collide once. Pair k is grains 2k and 2k+1; it touches after
/// (lead + (k + 1/2)/count) time steps, so that the entry phases of a run cover one step evenly.
struct Pairs {
    std::size_t count = 0;        ///< > 0
    double approach_speed = 0;    ///< relative speed along x (length/time), > 0
    double impact_parameter = 0;  ///< offset along y (length), |b| < d; 0 is head-on
    bool frozen_partner = false;  ///< grain 2k+1 never moves
    double lead_steps = 3;        ///< whole time steps of free flight before the first touch
};

/// Isolated grains thrown at one plate, with entry phases as in Pairs.
struct Bounces {
    std::size_t count = 0;  ///< > 0; 1 for the free lid, which all grains would share
    double speed = 0;       ///< towards the plate (length/time), > 0
    Target target = Target::bottom;
    double lead_steps = 3;
};

/// Grains on a jittered square lattice that fills the periodic box, Gaussian velocities with zero
/// total momentum.
struct Gas {
    std::size_t count = 0;
    double velocity_spread = 0;  ///< standard deviation of each component
};

/// Rows of a jittered, slightly expanded triangular lattice above the bottom plate, small Gaussian
/// velocities.
struct Lattice {
    std::size_t count = 0;
    std::size_t columns = 0;  ///< grains per row; period / columns must exceed d
    double velocity_spread = 0;
    double lid_gap = 0;  ///< free height between the highest grain and the lid, > 0
};

/// The densest triangular lattice, every grain touching its six neighbours without overlap: rows of
/// L = period/d grains (a whole number, or as many as fit if it is a little more), the first on the
/// bottom plate, Gaussian velocities. Grain i of row j is number j L + i.
struct Packing {
    std::size_t count = 0;  ///< a multiple of L
    double velocity_spread = 0;
};

/// Given grain by grain.
struct Explicit {
    InitialState state;
};

using InitialStateRecipe = std::variant<Pairs, Bounces, Gas, Lattice, Packing, Explicit>;

/// Fills scene.initial (and the height of a free lid for Lattice and Bounces) from the recipe.
/// All else of the scene must be set. Throws std::invalid_argument with a one-line reason if the
/// grains do not fit, touch at the start, or are frozen and move.
void generate_initial_state(Scene& scene, const InitialStateRecipe& recipe);

}  // namespace crossgrain::scene
