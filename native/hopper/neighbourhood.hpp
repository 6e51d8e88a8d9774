// All that a move can depend on: the states of the six neighbours of a hole, 5^6 possibilities.
#pragma once

#include "native/hopper/energy.hpp"

#include <cstddef>
#include <cstdint>

namespace crossgrain::hopper {

inline constexpr std::uint32_t states = 5;
inline constexpr std::uint32_t neighbourhoods = states * states * states * states * states * states;

/// The cell, empty in the middle, whose nodes 2..7 are the digits of `index` to base 5, node 2 the
/// lowest; index < neighbourhoods.
[[nodiscard]] constexpr Cell neighbourhood(std::uint32_t index) noexcept {
    Cell cell{};
    for (std::size_t j = 2; j <= 7; ++j) {
        cell[j] = static_cast<std::uint8_t>(index % states);
        index /= states;
    }
    return cell;
}

}  // namespace crossgrain::hopper
