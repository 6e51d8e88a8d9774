// Half Verlet list of pairs closer than d + skin, built from cells, valid while no grain has moved
// by more than skin/2 (Verlet 1967; Allen & Tildesley, sec. 5.3).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::dem {

struct Pair {
    std::uint32_t i = 0;
    std::uint32_t j = 0;
    double shift_x = 0;  ///< added to x_i - x_j: a multiple of the period (nearest image)
    double shift_y = 0;  ///< added to y_i - y_j
};

class NeighbourList {
  public:
    /// `reach` is the interaction range d. A period must be at least 2 (reach + skin), so that no
    /// grain meets two images of another.
    NeighbourList(double reach, double skin, std::optional<double> period_x,
                  std::optional<double> period_y);

    /// Rebuilds if a grain has moved by more than skin/2 since the last build.
    /// Throws TrajectoryError if a position is not finite (or beyond 1e12 times the list range).
    void update(std::span<const double> x, std::span<const double> y);

    [[nodiscard]] const std::vector<Pair>& pairs() const noexcept { return pairs_; }
    [[nodiscard]] std::int64_t builds() const noexcept { return builds_; }

  private:
    struct Axis;
    struct Cells;
    [[nodiscard]] Axis make_axis(std::span<const double> values,
                                 const std::optional<double>& period, char name) const;
    [[nodiscard]] bool outdated(std::span<const double> x, std::span<const double> y) const;
    [[nodiscard]] Cells make_cells(std::span<const double> x, std::span<const double> y) const;
    void build(std::span<const double> x, std::span<const double> y);
    void pair_up(const Cells& cells, std::span<const double> x, std::span<const double> y);

    double range_;  ///< d + skin
    double skin_;
    std::optional<double> period_x_, period_y_;
    std::vector<Pair> pairs_;
    std::vector<double> x_built_, y_built_;
    std::int64_t builds_ = 0;
};

}  // namespace crossgrain::dem
