// A lattice gas in a pipe: everything that decides a trajectory. Peng and Herrmann (1995).
#pragma once

#include "native/lga/rules.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::lga {

/// What one kick of gravity does; its target must be empty before the step (Fig. 1c).
struct GravityRule {
    bool rest_to_down = true;  ///< R -> 0
    bool up_diagonals = true;  ///< 2 -> 1 and 4 -> 5
    bool up_to_rest = false;   ///< 3 -> R
    bool on_walls = false;     ///< also at wall sites (diagonals only)
};

/// The two wall columns are counted in the width, or are added on both sides of it.
enum class WallPlace { inside, outside };

/// Where the rest particles beyond one per site go: first to the sites that the stopped particles
/// came from, or straight on a random walk.
enum class Relocation { origin_first, random_walk };

/// All ranges are checked by whoever reads the input; the engines check what they rely on.
struct Model {
    std::vector<Rule> rules;
    GravityRule gravity_rule;
    WallPlace walls = WallPlace::outside;
    Relocation relocation = Relocation::origin_first;

    int length = 0;        ///< L, sites along the pipe, > 0
    int width = 0;         ///< W, sites across, >= 3
    bool periodic = true;  ///< or open: fed at the top, free exit at both ends, empty at first
    double density = 0;    ///< rho, periodic pipes only; N = round(rho L W) particles
    double injection = 0;  ///< I in [0, 1], open pipes only
    double gravity = 0;    ///< g in [0, 1]
    double roughness = 0;  ///< b in [0, 1]
    int replicas = 1;      ///< 1 to 512
    std::uint64_t seed = 0;
};

inline constexpr int max_replicas = 512;

}  // namespace crossgrain::lga
