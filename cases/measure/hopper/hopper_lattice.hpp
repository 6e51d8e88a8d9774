// Sites of a hopper's triangular lattice by column and half-level, for estimators.
#pragma once

#include "cases/scene/hopper_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>

namespace crossgrain::measure {

/// x of column 1 and y of half-level 1, in lattice spacings.
inline constexpr double column_spacing = std::numbers::sqrt3 / 2;
inline constexpr double level_spacing = 0.5;

inline constexpr std::size_t no_site = std::numeric_limits<std::size_t>::max();

/// Index into HopperFrame::state of the site in column c of half-level k; no_site outside.
[[nodiscard]] inline std::size_t site_at(std::span<const scene::HopperLevel> levels, std::int64_t k,
                                         std::int64_t c) noexcept {
    if (k < 0 || k >= static_cast<std::int64_t>(levels.size())) return no_site;
    const scene::HopperLevel& level = levels[static_cast<std::size_t>(k)];
    if (c < level.first || c > level.last || (c - level.first) % 2 != 0) return no_site;
    return level.offset + static_cast<std::size_t>((c - level.first) / 2);
}

/// Beyond 120 degrees the walls are flatter than the 30 degrees along which a grain can move: what
/// lies on them stays, and a reach along the wall has no meaning.
inline constexpr double widest_meaningful_angle = 120;

}  // namespace crossgrain::measure
