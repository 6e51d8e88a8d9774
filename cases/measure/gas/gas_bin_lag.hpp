// Whether all bins of a frame show the same instant (a check of what takes the frames, not of the
// gas). A periodic pipe looks the same from every bin, so the covariance of neighbours
//
//   C_i(T) = <n_i(t) n_{i+1}(t + T)>,   n_i minus the mean over the pipe at that time,
//
// is the same for all i. Where something travels, C_i falls or rises at T = 0, by
// C' = (C(1) - C(-1))/2 per frame, and a bin that is e frames late against its neighbour shows as
// C_i(0) = C(0) + e C'. The variance of e over the pairs,
//
//   V = <(C_i(0) - C(0))^2>_i/C'^2,
//
// is formed from products of different replicas, so that their noise has no share in it: it is 0
// +- noise if no bin is late; one late bin of B by one frame makes 2/B, every second one 1.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::measure {

/// Measurement `bin_lag_variance` V, frames^2; error by the jackknife over the replicas. Nothing if
/// C' is below five of its standard errors: nothing travels, and a late bin is not seen. V is
/// linear in C: beyond a frame or so it tells that bins are late, not by how much.
class GasBinLag final : public GasEstimator {
  public:
    /// Throws std::invalid_argument for an open pipe, without the field `count`, with fewer than
    /// four bins or three replicas.
    explicit GasBinLag(const scene::GasSampling& sampling);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    [[nodiscard]] double variance_without(std::size_t replica) const;

    std::size_t bins_, replicas_;
    std::int64_t frames_ = 0;
    std::vector<float> field_, before_;  ///< n_i of this frame and the one before
    /// Sums over the frames: C_i(0), shape (bins, replicas); C(1) - C(-1) of all bins, (replicas).
    std::vector<double> same_time_, transport_;
    std::vector<double> pair_sums_, pair_squares_;  ///< of C_i(0) - C(0), shape (bins)
    double transport_sum_ = 0;
};

}  // namespace crossgrain::measure
