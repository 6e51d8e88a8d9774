// What one run of the hopper automaton is: the hopper, the reading of the rules, the random
// numbers. Gremaud, "Numerical simulation of pattern formation in grain flows", sections 2 and 3.
// Reduced units: lattice spacing 1, one iteration.
#pragma once

#include <cstdint>

namespace crossgrain::hopper {

/// Order in which the levels are visited in an iteration. Only from bottom to top does a hole rise
/// through the whole hopper in one iteration; the other order gives mass flow at no angle.
enum class Sweep { bottom_to_top, top_to_bottom };

/// What a level is: one half-level of the triangular lattice, or a zigzag row of two.
enum class Rows { half_levels, zigzag };

/// E_I = C_I |s - o| with s the source's orientation and o the new one, or the printed
/// C_I |ILOC(I) - INEW(I)|, whose INEW(I) is 0 once the grain has left.
enum class Inertia { source_orientation, literal };

/// Order and ties from numbers of (iteration, site), or from one stream that all sites share: then
/// one tie more anywhere shifts all later numbers (the paper's Experiment 2).
enum class RandomSource { per_site, shared_stream };

/// The energy of a configuration and what counts as a tie. Decimal numbers with at most 12 digits
/// after the point (fixed_point.hpp), in [0, 1e5].
struct Rules {
    double c_d = 0;               ///< C_D, density: unlike neighbours
    double c_o = 0;               ///< C_O, orientation against direction of motion
    double c_i = 0;               ///< C_I, inertia: rotation
    double c_w = 0;               ///< C_W, wall
    double tie_tolerance = 1e-3;  ///< eps: all candidates with E <= E_min + eps are as good
    Inertia inertia = Inertia::source_orientation;
    bool rotation = true;  ///< a moving grain may take a new orientation
};

struct Parameters {
    int outlet = 0;    ///< N, sites of the outlet, >= 2
    int levels = 0;    ///< L, half-levels, >= 1
    double angle = 0;  ///< theta, full opening angle (degrees), in (0, 180)
    Rules rules;
    Sweep sweep = Sweep::bottom_to_top;
    Rows rows = Rows::half_levels;
    RandomSource random = RandomSource::per_site;
    std::uint64_t seed = 0;
    std::uint32_t run =
        0;            ///< number of this run among those of the seed; each has its own numbers
    int flipped = 0;  ///< nodes whose initial orientation is changed (damage spreading), >= 0
};

/// Throws CaseError, in one line, for what is out of range, for a hopper of more than 10^8 sites,
/// and for a tie tolerance within which all candidates are always equal.
void check(const Parameters& parameters);

}  // namespace crossgrain::hopper
