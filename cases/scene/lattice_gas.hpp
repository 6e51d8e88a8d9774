// The lattice gas in a pipe as data: one reading of its rules, and one run with its ensemble.
// Peng and Herrmann (1995), "Density waves and 1/f density fluctuations in granular flow".
//
// Directions (facts of the triangular lattice with one vertical axis): 0 down (along gravity),
// 1 down-right, 2 up-right, 3 up, 4 up-left, 5 down-left; R is a particle at rest. Columns are
// vertical; odd columns sit half a site lower. Reduced units: one site, one time step.
#pragma once

#include "cases/scene/gas_sampling.hpp"
#include "native/base/enum_words.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::scene {

using crossgrain::to_string;

/// Probability as the paper writes it: constant + p_factor * p, with p the dissipation parameter.
struct RuleProbability {
    double constant = 0;
    double p_factor = 0;
    [[nodiscard]] double at(double p) const noexcept { return constant + p_factor * p; }
};

/// Particles of one site: bit i is a mover along direction i; rests may exceed one after a
/// collision (they are relocated).
struct SiteState {
    std::uint8_t movers = 0;  ///< bits 0..5
    std::uint8_t rests = 0;   ///< 0 or 1 before a collision, up to 7 after it
    friend bool operator==(const SiteState&, const SiteState&) = default;
};

/// Whether a row holds only when its configuration is all there is at the site, or also when other
/// movers ("spectators") are there, as long as none of them is along a direction the outcome fills.
/// Rest particles are never spectators: their number is part of the configuration.
enum class Matching { exact, spectators };
constexpr auto words(Matching /*of*/) {
    return std::array{"exact", "spectators"};
}

/// One line of a collision table. Before and after have the same mass and the same momentum.
/// What is missing from 1 over the rows of a configuration stays as it is. If several
/// configurations apply at a site, one is chosen uniformly, then its outcome.
struct CollisionRow {
    SiteState before, after;
    RuleProbability probability;
    Matching matching = Matching::exact;  ///< the same for all rows of a configuration
    int line = 0;                         ///< in the reading's file
};

struct GravityRule {
    bool rest_to_down = true;  ///< R -> 0
    bool up_diagonals = true;  ///< 2 -> 1 and 4 -> 5
    bool up_to_rest = false;   ///< 3 -> R, if there is no R
    bool on_walls = false;     ///< gravity also acts at wall sites
};

/// Where the two wall columns are: counted inside the width W, or added outside it.
enum class WallPlace { inside, outside };
constexpr auto words(WallPlace /*of*/) {
    return std::array{"inside", "outside"};
}

/// Where a rest particle beyond one per site goes first: to the origin of one of the particles
/// that stopped (x - v_i, chosen at random; taken or a wall: a random walk goes on from the site),
/// or straight on a random walk over non-wall neighbours.
enum class Relocation { origin_first, random_walk };
constexpr auto words(Relocation /*of*/) {
    return std::array{"origin-first", "random-walk"};
}

/// A named reading of the rules, of which the paper's Fig. 1 is lost.
struct GasReading {
    std::string name;  ///< e.g. "P"
    std::string text;
    std::vector<CollisionRow> rows;  ///< expanded: one per rotation and mirror image
    GravityRule gravity;
    WallPlace walls = WallPlace::outside;
    Relocation relocation = Relocation::origin_first;
    std::string file;
};

enum class PipeEnds { periodic, open };
constexpr auto words(PipeEnds /*of*/) {
    return std::array{"periodic", "open"};
}

/// What is done when particles at rest exceed the sites that can hold them.
enum class OnSaturation { fail, record };
constexpr auto words(OnSaturation /*of*/) {
    return std::array{"fail", "record"};
}

/// Which engine: both give the same bits, replica by replica.
enum class GasEngine { bit_sliced, table };
constexpr auto words(GasEngine /*of*/) {
    return std::array{"bit-sliced", "table"};
}

/// One run: an ensemble of replicas with the same parameters and their own random numbers.
struct LatticeGas {
    std::string name;  ///< case and variant
    GasReading reading;
    GasSampling sampling;  ///< size, duration, ensemble, frames
    PipeEnds ends = PipeEnds::periodic;
    double density = 0;      ///< rho, particles per site, in (0, 7]; N = rho L W exactly
    double injection = 0;    ///< I in [0, 1], open pipes only (they start empty)
    double dissipation = 0;  ///< p in [0, 1]
    double gravity = 0;      ///< g in [0, 1]
    double roughness = 0;    ///< b in [0, 1]
    GasEngine engine = GasEngine::bit_sliced;
    std::optional<int> word_bits;  ///< of the bit-sliced engine; absent: the best for the replicas
    OnSaturation on_saturation = OnSaturation::fail;
    std::uint64_t seed = 0;
};

}  // namespace crossgrain::scene
