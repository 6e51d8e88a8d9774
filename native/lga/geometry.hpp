// Columns and neighbours of the pipe. Columns are vertical, rows are counted downward, and odd
// columns (counted from the first of the W) sit half a site lower.
#pragma once

#include "native/base/errors.hpp"
#include "native/lga/model.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace crossgrain::lga {

struct Site {
    int column = 0;
    int row = 0;
};

class Geometry {
  public:
    /// Throws CaseError for more sites than an int counts.
    explicit Geometry(const Model& model)
        : outside_(model.walls == WallPlace::outside ? 1 : 0), columns_(model.width + 2 * outside_),
          rows_(model.length), periodic_(model.periodic) {
        const std::int64_t sites = std::int64_t{columns_} * rows_;
        if (sites > std::numeric_limits<int>::max() - 1) {
            throw CaseError({.key = "scene.length",
                             .problem = "makes too large a pipe",
                             .got = std::to_string(sites) + " sites",
                             .expected = "fewer than 2^31"});
        }
    }

    /// Wall columns included: the first and the last one.
    [[nodiscard]] int columns() const noexcept { return columns_; }
    [[nodiscard]] int rows() const noexcept { return rows_; }
    [[nodiscard]] int sites() const noexcept { return columns_ * rows_; }
    /// Sites that can hold a particle at rest.
    [[nodiscard]] int interior_sites() const noexcept { return (columns_ - 2) * rows_; }
    [[nodiscard]] bool is_wall(int column) const noexcept {
        return column == 0 || column == columns_ - 1;
    }
    /// Half a site lower than its neighbours.
    [[nodiscard]] bool is_low(int column) const noexcept { return ((column - outside_) & 1) != 0; }
    [[nodiscard]] bool periodic() const noexcept { return periodic_; }

    [[nodiscard]] static int column_step(int direction) noexcept {
        constexpr int steps[directions] = {0, 1, 1, 0, -1, -1};
        return steps[direction];
    }
    /// Rows passed on the way from a site of `column` to its neighbour.
    [[nodiscard]] int row_step(int direction, int column) const noexcept {
        constexpr int from_high[directions] = {1, 0, -1, -1, -1, 0};
        constexpr int from_low[directions] = {1, 1, 0, -1, 0, 1};
        return is_low(column) ? from_low[direction] : from_high[direction];
    }
    /// The row after `row + step`, step in {-1, 0, 1}, or -1 beyond the end of an open pipe.
    [[nodiscard]] int row_after(int row, int step) const noexcept {
        const int next = row + step;
        if (next >= 0 && next < rows_) return next;
        if (!periodic_) return -1;
        return next < 0 ? next + rows_ : next - rows_;
    }
    /// Whether direction 0, 1 or 5 of a site of the top row is fed from outside: the interior
    /// states that nothing inside leads to, and the downward diagonal of the wall sites.
    [[nodiscard]] bool is_fed(int column, int direction) const noexcept {
        if (column == 0) return direction == 1;
        if (column == columns_ - 1) return direction == 5;
        return direction == 0 || ((direction == 1 || direction == 5) && !is_low(column));
    }
    /// Index of a site, the row running fastest.
    [[nodiscard]] int index(Site site) const noexcept { return site.column * rows_ + site.row; }
    /// Index of the neighbour of an interior site, or -1 if it cannot hold a particle at rest.
    [[nodiscard]] int interior_neighbour(Site site, int direction) const noexcept {
        const int column = site.column + column_step(direction);
        if (is_wall(column)) return -1;
        const int row = row_after(site.row, row_step(direction, site.column));
        return row < 0 ? -1 : index({.column = column, .row = row});
    }

  private:
    int outside_;
    int columns_;
    int rows_;
    bool periodic_;
};

}  // namespace crossgrain::lga
