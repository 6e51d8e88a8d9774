// Makes the padded list of simd_format.hpp and the order in which it wants the grains: sorted by
// cell (neighbour_search.hpp) and, within a window of some cells, by number of neighbours, so that
// the grains of a group have about as many.
#pragma once

#include "native/dem/neighbour_search.hpp"
#include "native/dem/simd_format.hpp"
#include "native/dem/thread_team.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::dem {

struct PaddedListShape {
    double diameter = 0;
    double skin = 0;                 ///< pairs nearer than diameter + skin are listed
    std::optional<double> period_x;  ///< at least 4 (diameter + skin)
    GroupShape group;                ///< of the vectors that will use the list
    std::size_t record_size = 0;     ///< bytes
};

struct Bounds {
    double low = 0, high = 0;
};

class PaddedListMaker {
  public:
    /// Positions, shape (grains), x within [0, period) where there is one. Returns the order of the
    /// grains: place i has grain order[i]. Throws TrajectoryError when grains are crowded beyond
    /// all sense.
    const std::vector<std::uint32_t>& make(std::span<const double> x, std::span<const double> y,
                                           const PaddedListShape& shape, ThreadTeam& team,
                                           PaddedList& list);

    /// Of the grains of the last list.
    [[nodiscard]] const Bounds& heights() const noexcept { return heights_; }

  private:
    /// What one thread has found for its windows, and the rows that it makes of it.
    struct Part {
        std::size_t first_window = 0, last_window = 0;
        FoundNeighbours found;
        std::vector<std::uint32_t> rows;     ///< shape (groups)
        std::vector<std::uint32_t> offsets;  ///< shape (rows, lanes)
    };

    void sort_by_cell(std::span<const double> x, std::span<const double> y,
                      const PaddedListShape& shape, ThreadTeam& team);
    void set_cells(std::span<const double> x, std::span<const double> y,
                   const PaddedListShape& shape, ThreadTeam& team);
    void find(Part& part);
    void sort_windows(Part& part);
    void write_rows(Part& part, const PaddedListShape& shape, PaddedList& list) const;
    void join(const PaddedListShape& shape, ThreadTeam& team, PaddedList& list);

    CellView cells_;
    Bounds heights_;
    double low_x_ = 0, per_width_ = 0, per_height_ = 0;
    std::vector<std::uint32_t> by_cell_;  ///< grains in the order of cells
    std::vector<std::uint32_t> from_;     ///< place in the order of cells of what is at a place
    std::vector<std::uint32_t> place_;    ///< the inverse of from_
    std::vector<std::uint32_t> order_;
    std::vector<std::size_t> first_neighbour_;  ///< by place in the order of cells, in its part
    std::vector<Part> parts_;
};

}  // namespace crossgrain::dem
