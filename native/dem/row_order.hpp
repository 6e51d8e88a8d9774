// The rows of a group's neighbours in the order in which they can begin to matter.
#pragma once

#include <cstddef>
#include <cstdint>

namespace crossgrain::dem {

/// Sorts each lane of a group by distance: nearest neighbours in the first row. `offsets` and
/// `distances_squared` have shape (rows, lanes), lanes = 2, 4, 8 or 16, `nearest_squared` has shape
/// (rows): the smallest distance of a row and all rows behind it.
using OrderRows = void (*)(std::size_t rows, std::size_t lanes, std::uint32_t* offsets,
                           float* distances_squared, float* nearest_squared);

/// The fastest one on this machine; all give the same.
[[nodiscard]] OrderRows order_rows_function();

}  // namespace crossgrain::dem
