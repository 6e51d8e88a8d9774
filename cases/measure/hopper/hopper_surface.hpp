// The free surface of a hopper: its profile, slopes and scatter. Gremaud, section 2 (Fig. 6) and
// Experiments 2 and 3.
#pragma once

#include "cases/measure/estimator.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace crossgrain::measure {

/// One angle; from the last frame of each replica. h(c): y of the highest grain of column c; the
/// crater: columns whose surface lies more than two spacings below the initial one.
/// Measurements (mean and standard error over the replicas; absent without a crater):
/// - crater_depth (spacings): initial surface minus the lowest point of h;
/// - crater_half_width (spacings): half the crater's width;
/// - surface_slope (degrees): arctan of the least-squares |dh/dx| of both flanks, between the
/// lowest
///   point and the rim;
/// - surface_slope_steepest (degrees): the largest |dh/dx| over eight columns;
/// - steep_share: share of replicas whose surface_slope exceeds the 30 degrees that the lattice
///   would seem to allow;
/// - surface_scatter: standard deviation of h between replicas, root mean square over the crater,
///   divided by the mean depth; from pairs of replicas, each pair a sample.
/// Series "surface": x, h, standard_error.
class HopperSurface final : public HopperEstimator {
  public:
    /// Throws std::invalid_argument for more than one angle.
    explicit HopperSurface(const scene::HopperAutomaton& scene);
    void add(const scene::HopperFrame& frame) override;
    void finish(Results& results) override;

  private:
    void append_series(Results& results) const;
    void append_scatter(Results& results, std::span<const double> depths) const;

    int replicas_;
    double top_;
    std::int32_t first_column_ = 0;
    std::vector<std::vector<double>> profiles_;  ///< shape (replicas, columns): h, or -1 if empty
};

}  // namespace crossgrain::measure
