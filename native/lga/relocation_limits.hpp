// When the relocation of rest particles ends without success; the same in both engines.
//
// Relocation goes in rounds. In a round every site that holds rests beyond one sends one of them to
// one of its six neighbours, chosen by three random bits (0..5 a direction, 6 and 7 wait). A
// neighbour that is a wall or beyond an open end: wait. All arrive at once; of those that arrive at
// a site without a rest particle one settles, and the others walk on from there in the next round.
#pragma once

#include "native/lga/geometry.hpp"

#include <cstdint>

namespace crossgrain::lga {

/// Before this round, rests are counted in replicas that still relocate: with more of them than
/// interior sites the replica is saturated.
inline constexpr int saturation_round = 16;

/// A replica that is not done after so many rounds counts as saturated, too.
[[nodiscard]] inline std::int64_t max_rounds(const Geometry& geometry) noexcept {
    return 100 * std::int64_t{geometry.interior_sites()};
}

}  // namespace crossgrain::lga
