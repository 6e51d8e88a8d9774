// Orientations in a box of a hopper and their correlations in space and time.
//
// For grains with orientations s and s' a separation apart, with q = 3 orientations of which f_o
// and f'_o are the fractions among the pairs,
//   G = (<delta(s, s')> - sum_o f_o f'_o) / (1 - sum_o f_o f'_o):
// 1 for equal orientations, 0 for independent ones, whatever the fractions.
#pragma once

#include "cases/scene/hopper_frame.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace crossgrain::measure {

/// Pairs of grains by their orientations.
struct OrientationPairs {
    std::array<std::array<std::uint64_t, 3>, 3> count{};  ///< [s - 1][s' - 1]

    void add(std::uint8_t s, std::uint8_t other) noexcept {
        if (s != 0 && other != 0) ++count[s - 1U][other - 1U];
    }
    [[nodiscard]] std::uint64_t total() const noexcept;
    /// G over all orientations; nothing without pairs or if all grains are alike.
    [[nodiscard]] std::optional<double> correlation() const;
    /// Correlation coefficient of "has orientation o" (1..3) at both ends; nothing if all or none
    /// have it.
    [[nodiscard]] std::optional<double> correlation_of(std::uint8_t o) const;
    /// The same for any of several orientations: sum of covariances over sum of variances.
    [[nodiscard]] std::optional<double> correlation_of_slanted() const;
};

/// Where the box lies, in lattice spacings: |x| <= half_width, from <= y <= to.
struct BoxBounds {
    double half_width = 0, from = 0, to = 0;
};

/// Copy of the orientations in a box: columns and half-levels as a dense array, 0 where there is no
/// site or no grain.
class OrientationBox {
  public:
    OrientationBox(const scene::HopperFrame& frame, const BoxBounds& bounds);

    [[nodiscard]] int columns() const noexcept { return columns_; }
    [[nodiscard]] int levels() const noexcept { return levels_; }
    /// Orientation at column and half-level of the box, both from 0.
    [[nodiscard]] std::uint8_t at(int column, int level) const noexcept {
        return state_[static_cast<std::size_t>(level) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(column)];
    }
    /// Fraction of vertical grains (orientation 2); nothing without grains.
    [[nodiscard]] std::optional<double> vertical_fraction() const;
    /// Pairs of a grain of this box and the grain of `other`, which has the same bounds, that lies
    /// `columns` and `levels` further.
    [[nodiscard]] OrientationPairs pairs(const OrientationBox& other, int columns,
                                         int levels) const;

  private:
    int columns_ = 0, levels_ = 0;
    std::vector<std::uint8_t> state_;
};

/// Spatial correlations of one box.
struct PatternShape {
    double neighbour = 0;         ///< g1: mean G of the six nearest neighbours
    std::vector<double> along_x;  ///< G at separations 0, sqrt(3), 2 sqrt(3), ... on one level
    std::vector<double> along_y;  ///< G at separations 0, 1, 2, ... in one column
    double length_x = 0, length_y = 0;          ///< where G falls to 1/e, interpolated linearly
    bool bounded_x = false, bounded_y = false;  ///< G stays above 1/e: the largest separation
};

/// Separations up to three quarters of the box. Nothing for a box without two different grains.
[[nodiscard]] std::optional<PatternShape> pattern_shape(const OrientationBox& box);

/// Pairs of grains `lag` iterations apart, by the vertical shift between them.
class SpaceTimeCounts {
  public:
    static constexpr int largest_shift = 15;  ///< spacings, up and down
    void add(const OrientationBox& earlier, const OrientationBox& later);
    [[nodiscard]] const OrientationPairs& at(int shift) const {
        const int from_lowest = shift + largest_shift;
        return pairs_[static_cast<std::size_t>(from_lowest)];
    }

  private:
    std::array<OrientationPairs, 2 * largest_shift + 1> pairs_{};
};

/// Shift of the highest correlation (parabola through its three highest points) and its height.
struct CorrelationPeak {
    double shift = 0;
    double height = 0;
};

struct PatternShift {
    std::optional<CorrelationPeak> all, vertical, slanted;
};

/// Nothing where the highest point lies at the largest shift.
[[nodiscard]] PatternShift pattern_shift(const SpaceTimeCounts& counts);

}  // namespace crossgrain::measure
