// All pairs of grains that overlap, in O(N) per frame by a grid of cells
// (Allen & Tildesley, Computer Simulation of Liquids, 2nd ed. (2017), section 5.3.2).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::scene {

/// Two grains i < j with r < d. The normal (nx, ny) points from j to i.
struct Contact {
    std::size_t i = 0, j = 0;
    double distance = 0;
    double nx = 0, ny = 0;
};

/// Positions may be unwrapped; along an axis with a period the nearest image is taken. Cells are
/// never smaller than a diameter, so that contacts lie in neighbouring cells whatever the overlap,
/// and never more than about 4 N, so that a few far-flung grains cost no memory. A periodic axis of
/// less than three cells, where a neighbour would be met twice, is searched as a single cell.
class ContactSearch {
  public:
    ContactSearch(double diameter, std::optional<double> period_x, std::optional<double> period_y);

    /// Valid until the next call; every pair once. Grains at the same place have normal (1, 0).
    [[nodiscard]] std::span<const Contact> find(std::span<const double> x,
                                                std::span<const double> y);

  private:
    /// The cells along one axis.
    struct Axis {
        double origin = 0;
        double cell = 1;  ///< length of a cell
        std::size_t count = 1;
        std::optional<double> period;

        [[nodiscard]] std::size_t index(double position) const;
        /// The neighbouring cell `step` = -1, 0, 1 away; nothing beyond the end of an open axis.
        [[nodiscard]] std::optional<std::size_t> neighbour(std::size_t cell, int step) const;
    };

    [[nodiscard]] Axis make_axis(std::span<const double> positions,
                                 const std::optional<double>& period) const;
    void sort_into_cells(std::span<const double> x, std::span<const double> y);
    void compare_cells(std::size_t a, std::size_t b, std::span<const double> x,
                       std::span<const double> y);
    void compare(std::size_t i, std::size_t j, std::span<const double> x,
                 std::span<const double> y);

    double diameter_;
    std::optional<double> period_x_, period_y_;
    Axis columns_, rows_;
    std::vector<std::size_t> cell_start_;  ///< shape (cells + 1)
    std::vector<std::size_t> cell_of_;     ///< shape (grains)
    std::vector<std::size_t> members_;     ///< grains in the order of their cells
    std::vector<Contact> contacts_;
};

}  // namespace crossgrain::scene
