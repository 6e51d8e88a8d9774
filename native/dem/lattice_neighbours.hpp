// Fixed neighbours (Taguchi, section 3): the pairs that are nearer than a cutoff at the start, and
// no others ever. Rows of such a lattice can slide through each other; a watch over all contacts
// counts the overlaps that the fixed topology does not see.
#pragma once

#include "native/dem/engine.hpp"
#include "native/dem/neighbour_list.hpp"

#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace crossgrain::dem {

class LatticeNeighbours {
  public:
    /// `parameters.lattice_cutoff` (0: 1.366 d) must be at least d, so that no contact is missed at
    /// the start. x, y: shape (grains). Throws std::invalid_argument, TrajectoryError.
    LatticeNeighbours(const Parameters& parameters, std::span<const double> x,
                      std::span<const double> y);

    [[nodiscard]] const std::vector<Pair>& pairs() const noexcept { return pairs_; }

    /// Looks for overlaps of grains that are no fixed neighbours.
    void watch(std::span<const double> x, std::span<const double> y, double time);
    [[nodiscard]] MissedContacts missed() const;

  private:
    using Numbers = std::pair<std::uint32_t, std::uint32_t>;

    double diameter_;
    std::vector<Pair> pairs_;
    std::set<Numbers> fixed_;
    NeighbourList all_;
    std::int64_t builds_ = 0;       ///< of all_, when strangers_ was made
    std::vector<Pair> strangers_;   ///< pairs of all_ that are not fixed
    std::set<Numbers> overlapped_;  ///< strangers that have overlapped
    std::optional<double> first_time_;
};

}  // namespace crossgrain::dem
