// Gremaud's hopper automaton as data: one reading of its rules, and one run.
// Gremaud, "Numerical simulation of pattern formation in grain flows", sections 2 and 3.
// Reduced units: lattice spacing 1, one iteration.
#pragma once

#include "native/base/enum_words.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace crossgrain::scene {

using crossgrain::to_string;

/// Order in which the levels are visited in an iteration.
enum class HopperSweep { bottom_to_top, top_to_bottom };
constexpr auto words(HopperSweep /*of*/) {
    return std::array{"bottom-to-top", "top-to-bottom"};
}
/// What a level is: one half-level of the triangular lattice, or a zigzag row of two.
enum class HopperRows { half_levels, zigzag };
constexpr auto words(HopperRows /*of*/) {
    return std::array{"half-levels", "zigzag"};
}
/// E_I = C_I |s - o| with s the source's orientation, or the literal printed INEW(I).
enum class HopperInertia { source_orientation, literal };
constexpr auto words(HopperInertia /*of*/) {
    return std::array{"source-orientation", "literal"};
}
/// Order and ties from numbers of (iteration, site), or from one stream shared by all sites (the
/// paper's Experiment 2).
enum class HopperRandom { per_site, shared_stream };
constexpr auto words(HopperRandom /*of*/) {
    return std::array{"per-site", "shared-stream"};
}
/// `fast`: hole lists and the mask table; `plain`: the rules as written. Same bits.
enum class HopperEngine { fast, plain };
constexpr auto words(HopperEngine /*of*/) {
    return std::array{"fast", "plain"};
}

/// A named reading of the rules.
struct HopperReading {
    std::string name = "standard";
    HopperSweep sweep = HopperSweep::bottom_to_top;
    HopperRows rows = HopperRows::half_levels;
    HopperInertia inertia = HopperInertia::source_orientation;
    bool rotation = true;         ///< a moving grain may take a new orientation
    double tie_tolerance = 1e-3;  ///< eps, absolute, >= 0
};

/// One run: all angles one after the other, each with its replicas.
struct HopperAutomaton {
    std::string name;  ///< case and variant
    HopperReading reading;
    int outlet = 0;              ///< N, sites of the outlet, >= 2
    int levels = 0;              ///< L, half-levels, >= 1
    std::vector<double> angles;  ///< full opening angles theta (degrees), in (0, 180)
    double c_d = 0, c_o = 0, c_i = 0, c_w = 0;  ///< C_D, C_O, C_I, C_W, >= 0
    std::int64_t iterations = 0;                ///< > 0
    std::int64_t every = 1;  ///< frames at iterations 0, every, ..., and at the last
    int replicas = 1;        ///< per angle, each with its own random numbers, >= 1
    int flipped = 0;         ///< damage spreading: nodes flipped in a twin of each replica
    HopperRandom random = HopperRandom::per_site;
    HopperEngine engine = HopperEngine::fast;
    std::uint64_t seed = 0;
};

}  // namespace crossgrain::scene
