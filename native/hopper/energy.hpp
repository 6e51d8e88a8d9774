// The energy of a hexagonal cell after a move, as integers (Gremaud, section 2d):
//   E = E_D + E_O + E_I + E_W
// A grain leaves source i (2, 3 or 4 of the local numbering) with orientation s and fills the hole
// 1 with orientation o.
#pragma once

#include "native/hopper/fixed_point.hpp"
#include "native/hopper/geometry.hpp"
#include "native/hopper/parameters.hpp"

#include <array>
#include <cstdint>

namespace crossgrain::hopper {

/// ILOC or INEW: states of the nodes 1..7 of the local numbering (geometry.hpp); [0] is not used.
using Cell = std::array<std::uint8_t, 8>;

/// The rules with integer coefficients.
struct Energies {
    Energy c_d = 0, c_o = 0, c_i = 0, c_w = 0;
    Energy tie_tolerance = 0;
    Inertia inertia = Inertia::source_orientation;
    bool rotation = true;
};

/// Throws CaseError when a coefficient is no decimal number of to_energy().
[[nodiscard]] Energies integer_energies(const Rules& rules);

/// What could fill the hole.
struct Candidate {
    int source = 0;       ///< i, 2..4
    int orientation = 0;  ///< o, 1..3
    friend bool operator==(const Candidate&, const Candidate&) = default;
};

/// Candidates are numbered 0..8 by source, then by orientation.
inline constexpr int candidate_count = 9;
[[nodiscard]] constexpr int number_of(const Candidate& candidate) noexcept {
    return 3 * (candidate.source - 2) + candidate.orientation - 1;
}
[[nodiscard]] constexpr Candidate candidate_of(int number) noexcept {
    return {.source = number / 3 + 2, .orientation = number % 3 + 1};
}

[[nodiscard]] constexpr bool occupied(std::uint8_t state) noexcept {
    return state >= 1 && state <= 3;
}

/// INEW: the cell after the move.
[[nodiscard]] Cell after_move(const Cell& iloc, const Candidate& candidate) noexcept;

/// E_D = C_D x number of neighbours inside the hopper that are not like the grain; empty sites
/// count, the one the grain has left among them.
[[nodiscard]] Energy density_energy(const Cell& inew, const Energies& c) noexcept;
/// E_O = C_O |(i - 1) - s|: a grain prefers to move along itself.
[[nodiscard]] Energy orientation_energy(const Cell& iloc, const Candidate& candidate,
                                        const Energies& c) noexcept;
/// E_I = C_I |s - o|, not cyclic, or C_I s as printed.
[[nodiscard]] Energy inertia_energy(const Cell& iloc, const Candidate& candidate,
                                    const Energies& c) noexcept;
/// E_W = C_W at a right wall (5 outside) unless o = 3, and C_W at a left wall (7 outside) unless
/// o = 1.
[[nodiscard]] Energy wall_energy(const Cell& inew, const Energies& c) noexcept;

[[nodiscard]] Energy total_energy(const Cell& iloc, const Candidate& candidate,
                                  const Energies& c) noexcept;

/// Bit number_of(candidate) for each candidate with E <= E_min + eps; 0 when nothing can fall.
[[nodiscard]] std::uint16_t best_candidates(const Cell& iloc, const Energies& c) noexcept;
/// The same without regard to energy: each occupied source with each orientation that it may take.
[[nodiscard]] std::uint16_t all_candidates(const Cell& iloc, const Energies& c) noexcept;

}  // namespace crossgrain::hopper
