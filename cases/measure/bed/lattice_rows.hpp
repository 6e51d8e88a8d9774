// The rows of the triangular lattice that a run starts from.
#pragma once

#include "cases/scene/scene.hpp"

#include <cstddef>
#include <optional>

namespace crossgrain::measure {

/// Grain i of row j is number j columns + i, rows upwards, grains of a row from left to right.
struct LatticeRows {
    std::size_t columns = 0;  ///< L
    std::size_t rows = 0;
};

/// The rows of the initial state: grains of equal height (to 1e-6 d), in the order above, equally
/// spaced over the period along x. Nothing for any other state.
[[nodiscard]] std::optional<LatticeRows> lattice_rows(const scene::Scene& scene);

}  // namespace crossgrain::measure
