// All pairs of grains that overlap, in O(N) per frame by a grid of cells
// (Allen & Tildesley, Computer Simulation of Liquids, 2nd ed. (2017), section 5.3.2).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::measure {

/// Two grains i < j with r < d. The normal (nx, ny) points from j to i.
struct Contact {
    std::size_t i = 0, j = 0;
    double distance = 0;
    double nx = 0, ny = 0;
};

/// Positions may be unwrapped; with a period the nearest image along x is taken. Cells are never
/// smaller than a diameter, so that contacts lie in neighbouring cells whatever the overlap; a
/// period of less than three cells, which would meet an image twice, is searched as one column.
class ContactSearch {
  public:
    ContactSearch(double diameter, std::optional<double> period_x);

    /// Valid until the next call; every pair once. Grains at the same place have normal (1, 0).
    [[nodiscard]] std::span<const Contact> find(std::span<const double> x,
                                                std::span<const double> y);

  private:
    struct Grid {
        std::size_t columns = 1, rows = 1;
        double x0 = 0, y0 = 0;
        double width = 0, height = 0;  ///< of a cell
        bool wraps = false;
    };

    [[nodiscard]] Grid make_grid(std::span<const double> x, std::span<const double> y) const;
    void sort_into_cells(const Grid& grid, std::span<const double> x, std::span<const double> y);
    void compare_cells(std::size_t a, std::size_t b, std::span<const double> x,
                       std::span<const double> y);
    void compare(std::size_t i, std::size_t j, std::span<const double> x,
                 std::span<const double> y);

    double diameter_;
    std::optional<double> period_;
    std::vector<std::size_t> cell_start_;  ///< shape (cells + 1)
    std::vector<std::size_t> cell_of_;     ///< shape (grains)
    std::vector<std::size_t> members_;     ///< grains in the order of their cells
    std::vector<Contact> contacts_;
};

}  // namespace crossgrain::measure
