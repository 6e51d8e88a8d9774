// The random order of the holes of a level, and the numbers that choose among ties, many holes at a
// time (Highway, for the processor at hand).
#pragma once

#include "native/hopper/numbers.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace crossgrain::hopper {

/// Holes of one level, in any order; room for `order_padding` more than count.
struct LevelHoles {
    const std::uint32_t* place = nullptr;  ///< in a stored field
    std::size_t count = 0;
};

/// Numbers of these holes; room for `order_padding` more than there are holes.
struct LevelNumbers {
    std::uint32_t* order = nullptr;  ///< MoveNumbers::order
    std::uint32_t* tie = nullptr;    ///< MoveNumbers::tie
    std::uint32_t* rank = nullptr;   ///< 0 for the hole that is filled first
};

inline constexpr std::size_t order_padding = 64;
/// Ranks are worked out in blocks: a level has about this many holes (N = 20).
inline constexpr std::size_t order_block = 16;

/// Numbers::of_move of one iteration, for many sites at a time. What is the same for all sites is
/// worked out once: in the first two rounds of the generator half of the words.
struct IterationNumbers {
    static constexpr std::size_t rounds = 7;

    IterationNumbers() = default;
    IterationNumbers(const Numbers& numbers, std::uint32_t iteration);

    std::uint32_t first_2 = 0;                           ///< to word 2 after the first round
    std::uint32_t second_0 = 0, second_2 = 0;            ///< to words 0 and 2 after the second
    std::uint32_t second_3 = 0;                          ///< word 3 after the second
    std::array<std::uint32_t, rounds> key_0{}, key_1{};  ///< of the later rounds
};

/// Order, tie and rank of each hole; `site_of_place` is added to a place (modulo 2^32) to give the
/// number of the site. Ranks are those of (order, site), ascending.
void number_holes(const LevelHoles& holes, const IterationNumbers& iteration,
                  std::uint32_t site_of_place, const LevelNumbers& numbers);

}  // namespace crossgrain::hopper
