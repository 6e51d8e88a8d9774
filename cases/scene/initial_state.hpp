// Initial states, generated once, exactly, for every code: positions and velocities at t = 0 with
// nothing in contact, so that each code can start in its own convention without an approximation.
#pragma once

#include "cases/scene/scene.hpp"
#include "native/base/enum_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>
#include <vector>

namespace crossgrain::scene {

/// Which elastic plate a `Bounces` state is thrown at.
enum class Target { bottom, lid };
constexpr auto words(Target /*of*/) {
    return std::array{"bottom", "lid"};
}

/// How grains differ: diameters uniform in d (1 +- spread), seeded, masses m (d_i/d)^mass_exponent.
struct SizeSpread {
    double spread = 0;         ///< in [0, 1)
    double mass_exponent = 3;  ///< 3: spheres of one material, 2: discs, 0: one mass
};

/// A number that may change evenly from the first to the last of many.
struct Span {
    double first = 0, last = 0;
    [[nodiscard]] double at(std::size_t k, std::size_t count) const {
        if (count < 2 || first == last) return first;
        return first + (last - first) * static_cast<double>(k) / static_cast<double>(count - 1);
    }
    [[nodiscard]] double largest() const { return std::max(std::abs(first), std::abs(last)); }
};

/// Isolated pairs that collide once. Pair k is grains 2k and 2k+1; it touches after
/// (lead + (k + 1/2)/count) time steps, so that the entry phases of a run cover one step evenly.
struct Pairs {
    std::size_t count = 0;        ///< > 0
    double approach_speed = 0;    ///< relative speed along x (length/time), > 0
    double impact_parameter = 0;  ///< offset along y (length) at the touch, |b| < d; 0 is head-on
    bool frozen_partner = false;  ///< grain 2k+1 never moves
    double lead_steps = 3;        ///< whole time steps of free flight before the first touch
    Span tangential_speed = {};   ///< relative speed of grain 2k along y (length/time)
    Span spin = {};               ///< angular velocity of grain 2k (1/t)
    Span partner_spin = {};       ///< of grain 2k+1; 0 when it is frozen
    double partner_size = 1;      ///< diameter of grain 2k+1 over d, > 0; its mass as in SizeSpread
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
    double spin_spread = 0;      ///< standard deviation of the angular velocities
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

/// Grains that fall between two rough walls, in a period along y: frozen discs of diameter d in
/// columns at x = 0 and x = width, one staggered against the other by half their spacing, and N
/// grains with N pi d^2/4 = area_fraction (width - d) period_y, on a dilute jittered lattice.
/// Grains that move come first.
struct Pipe {
    double width = 0;            ///< between the columns' centres, > 2 d
    double wall_spacing = 0;     ///< of frozen discs along y; the nearest that divides the period
    double area_fraction = 0;    ///< of the grains in the clear width
    double velocity_spread = 0;  ///< standard deviation of each component
    double fall_speed = 0;       ///< mean speed along -y
    bool smooth = false;         ///< no discs in the walls
};

/// A hopper between two straight walls of touching frozen discs of diameter d, each theta/2 from
/// the vertical (theta is the whole opening angle, as in Gremaud's paper), with a plug of frozen
/// discs in its outlet at y = 0, and grains on a loose jittered lattice above it, as many as fill
/// it to `height` when they have settled to the area fraction `settled_fraction`. Grains that move
/// come first, then the walls, then the plug.
struct Hopper {
    double angle = 0;             ///< theta in degrees, in [0, 180)
    double outlet = 0;            ///< clear width between the lowest discs of the walls (length)
    double height = 0;            ///< of the settled filling (length)
    double settled_fraction = 0;  ///< in (0, 0.9)
    double velocity_spread = 0;   ///< standard deviation of each component
};

/// A hopper whose grains settle for a time before the run; then the plug is taken away. Scene::
/// preparation says so, and scene.initial is the state before.
struct Settled {
    Hopper hopper;
    double settle_time = 0;  ///< > 0
};

/// Given grain by grain.
struct Explicit {
    InitialState state;
    std::vector<double> diameters, masses;  ///< shape (grains), or both empty: all alike
};

using InitialStateRecipe =
    std::variant<Pairs, Bounces, Gas, Lattice, Packing, Pipe, Hopper, Settled, Explicit>;

/// Fills scene.initial (and the height of a free lid for Lattice and Bounces) from the recipe.
/// `sizes` applies to the grains that move. All else of the scene must be set. Throws
/// std::invalid_argument with a one-line reason if the grains are too many, do not fit, touch at
/// the start, are farther out than `farthest`, or are frozen and move.
void generate_initial_state(Scene& scene, const InitialStateRecipe& recipe,
                            const SizeSpread& sizes = {});

}  // namespace crossgrain::scene
