// What a site of the lattice gas can hold, and its collision rules as plain data.
// Peng and Herrmann (1995), "Density waves and 1/f density fluctuations in granular flow", Fig. 1.
//
// Directions: 0 down (along gravity), 1 down-right, 2 up-right, 3 up, 4 up-left, 5 down-left.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace crossgrain::lga {

inline constexpr int directions = 6;
/// Bit of the particle at rest in a packed site; bits 0..5 are the movers.
inline constexpr int rest_bit = 6;
inline constexpr int site_states = 128;

[[nodiscard]] constexpr int opposite(int direction) noexcept {
    return (direction + 3) % directions;
}

/// Particles of one site.
struct SiteState {
    std::uint8_t movers = 0;  ///< bit i: a mover along direction i
    std::uint8_t rests = 0;   ///< 0 or 1 before a collision, up to 7 after it
    friend bool operator==(const SiteState&, const SiteState&) = default;
};

[[nodiscard]] constexpr int mass(const SiteState& site) noexcept {
    return std::popcount(site.movers) + site.rests;
}

/// Downward velocities, in half sites per step.
inline constexpr std::array<int, directions> downward{2, 1, -1, -2, -1, 1};
/// Velocities to the right, in units of sqrt(3)/2 site per step.
inline constexpr std::array<int, directions> rightward{0, 1, 1, 0, -1, -1};

struct Momentum {
    int down = 0;   ///< in half sites per step
    int right = 0;  ///< in sqrt(3)/2 sites per step
    friend bool operator==(const Momentum&, const Momentum&) = default;
};

[[nodiscard]] constexpr Momentum momentum(std::uint8_t movers) noexcept {
    Momentum sum;
    for (int i = 0; i < directions; ++i) {
        if (((movers >> i) & 1) == 0) continue;
        sum.down += downward[static_cast<std::size_t>(i)];
        sum.right += rightward[static_cast<std::size_t>(i)];
    }
    return sum;
}

/// Whether a rule holds only for its very configuration, or also when other movers ("spectators")
/// are at the site, as long as none is along a direction that the outcome fills. Rest particles
/// are never spectators.
enum class Matching { exact, spectators };

/// One outcome of one configuration; what is missing from 1 over the rows with the same `before`
/// leaves the site as it is.
struct Rule {
    SiteState before, after;
    double probability = 0;  ///< in [0, 1]
    Matching matching = Matching::exact;
    std::string origin;  ///< where it was read, for messages, e.g. "P.toml:17"
};

/// e.g. "0 3 R".
[[nodiscard]] std::string to_string(const SiteState& site);

}  // namespace crossgrain::lga
