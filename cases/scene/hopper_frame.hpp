// One instant of a hopper, as estimators see it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace crossgrain::scene {

/// Sites of one half-level k: columns first, first + 2, ..., last (x = column sqrt(3)/2, y = k/2).
struct HopperLevel {
    std::int32_t first = 0;
    std::int32_t last = -1;  ///< < first when the level has no site
    std::size_t offset = 0;  ///< of the first site in `state`
    [[nodiscard]] std::size_t sites() const noexcept {
        return last < first ? 0 : static_cast<std::size_t>((last - first) / 2) + 1;
    }
};

/// Views are valid during the call only.
struct HopperFrame {
    std::size_t angle_index = 0;
    double angle = 0;  ///< theta, degrees
    int replica = 0;
    std::int64_t iteration = 0;           ///< iterations done; 0 is the initial state
    bool last = false;                    ///< no more frames of this angle and replica
    std::span<const HopperLevel> levels;  ///< shape (L)
    std::span<const std::uint8_t> state;  ///< shape (sites): 0 empty, 1..3 orientation
    std::span<const std::uint8_t> twin;   ///< the same for the flipped twin; empty without one
    std::span<const std::uint32_t> flow;  ///< shape (iteration): grains that left in each so far
    std::int64_t moves = 0;               ///< grain moves done so far
    /// Highest half-level whose outermost site at the wall was ever vacated; -1 for none.
    std::int32_t left_reach = -1, right_reach = -1;
};

}  // namespace crossgrain::scene
