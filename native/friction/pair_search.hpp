// Pairs of discs that can touch before one of them has left its margin. Each disc has margins of
// its own, so that a few fast grains do not lengthen the list of a slow packing: a pair is listed
// when some displacements within the margins of both bring it into contact. Frozen discs never pair
// with each other. (Verlet 1967 and cell lists: Allen & Tildesley, sec. 5.3.)
#pragma once

#include "native/friction/partner_scan.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::friction {

/// All spans have shape (discs); the first `mobile` can move, the others are frozen.
struct DiscView {
    std::span<const double> x, y;  ///< unwrapped
    std::span<const double> radius;
    std::span<const double> margin_x, margin_y;  ///< of mobile discs: shape (mobile)
    std::size_t mobile = 0;
};

/// `i` is mobile, `j` mobile or frozen; both are places, see PairSearch::order.
struct NearPair {
    std::uint32_t i = 0, j = 0;
    double shift_x = 0, shift_y = 0;  ///< added to x_i - x_j: multiples of the period
};

class PairSearch {
  public:
    PairSearch(std::optional<double> period_x, std::optional<double> period_y);

    /// The widest margin with which no disc meets two images of another; infinite without periods.
    /// Throws std::invalid_argument when a period is not above 4 radii.
    [[nodiscard]] double widest_margin(double largest_radius) const;

    /// Sorts the discs by cell and finds the pairs. Throws TrajectoryError when a position is not
    /// finite (or is beyond 1e9 largest radii).
    void find(const DiscView& discs);

    /// Place p has disc order()[p] of those given; mobile discs come first, neighbours next to each
    /// other.
    [[nodiscard]] const std::vector<std::uint32_t>& order() const noexcept { return order_; }
    [[nodiscard]] const std::vector<NearPair>& pairs() const noexcept { return pairs_; }

  private:
    /// Cells along one axis.
    struct Axis {
        double low = 0, per_length = 0;
        int cells = 1;
        std::optional<double> period;
        [[nodiscard]] int cell_of(double wrapped) const;
    };
    /// A stretch of cells, and what is added to x_i - x_j for discs in it.
    struct Segment {
        int first = 0, last = 0;
        double shift = 0;
    };
    [[nodiscard]] static Axis make_axis(std::span<const double> values,
                                        const std::optional<double>& period, double cell_size,
                                        char name);
    static void segments(const Axis& axis, double from, double to, std::vector<Segment>& found);
    void sort(const DiscView& discs);
    void copy_sorted(const DiscView& discs);
    void pair_up(std::size_t seeker);
    void scan(std::size_t seeker, std::size_t first_cell, const Segment& columns,
              const Segment& rows);

    std::optional<double> period_x_, period_y_;
    Axis axis_x_, axis_y_;
    SortedDiscs sorted_;
    std::vector<double> wrap_x_, wrap_y_;  ///< of sorted discs: wrapped - unwrapped
    std::vector<std::uint32_t> start_;     ///< shape (cells + 1): first sorted disc of a cell
    std::vector<std::uint32_t> place_;     ///< of sorted discs
    std::vector<std::uint32_t> mobile_;    ///< sorted discs by place, mobile ones only
    std::vector<std::uint32_t> found_;
    ScanForPartners scan_for_partners_ = scan_for_partners_function();
    double largest_radius_ = 0;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> cell_, next_, by_cell_;
    std::vector<Segment> columns_, rows_;
    std::vector<NearPair> pairs_;
};

}  // namespace crossgrain::friction
