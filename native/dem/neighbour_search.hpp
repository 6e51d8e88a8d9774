// Neighbours of grains that stand sorted by cell, found with the vectors of this machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain::dem {

/// Grains sorted by cell, cells ordered column by column: what is near along x is near in memory,
/// whatever the width of a bed, and the three cells of a column next to a grain are one stretch.
struct CellView {
    static constexpr std::size_t padding = 64;  ///< readable numbers beyond the last grain

    std::vector<float> x;              ///< shape (grains + padding): from the left of the column
    std::vector<float> y;              ///< shape (grains + padding): from the lowest grain
    std::vector<std::uint32_t> cell;   ///< shape (grains): column * rows + row
    std::vector<std::uint32_t> start;  ///< shape (cells + 1): first grain of a cell
    std::size_t columns = 1, rows = 1;
    float column_width = 0;
    bool periodic = false;
    float near_squared = 0;   ///< nearer than this is likely to touch while the list lasts
    float range_squared = 0;  ///< beyond this there are none
};

/// The neighbours of some grains, one after the other.
struct FoundNeighbours {
    std::vector<std::uint32_t> neighbours;  ///< flat; what is beyond the last one means nothing
    std::vector<std::uint32_t> counts;      ///< shape (grains asked for)
    std::vector<std::uint32_t>
        near_counts;                    ///< shape (grains asked for): of them, nearer than near
    std::vector<std::uint8_t> crosses;  ///< shape (grains asked for): across the period
    bool crowded = false;               ///< a grain has more than `most`: gave up
    static constexpr std::size_t most = 256;
};

/// Neighbours of the grains first ... last - 1, as numbers of sorted grains.
using FindNeighbours = void (*)(const CellView& cells, std::size_t first, std::size_t last,
                                FoundNeighbours& found);

/// The fastest one on this machine; all give the same.
[[nodiscard]] FindNeighbours find_neighbours_function();

}  // namespace crossgrain::dem
