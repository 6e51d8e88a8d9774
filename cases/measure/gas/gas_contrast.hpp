// Density contrast of a pipe (Peng & Herrmann 1995, Eq. 1),
//
//   C(t) = (1/nbar) sum_{i=1..K} |n_i(t) - n_{i+1}(t)|,   n_{K+1} = n_1.
//
// Its value for particles without correlation is not zero. With the 6 moving states of a site
// filled independently (the paper's initial state) n_i is binomial with variance
// nbar (1 - rho/6), the covariance forced by a fixed N cancels in the difference, and for normal
// deviates E|n_i - n_{i+1}| = 2 sigma/sqrt(pi), so
//
//   C_white = K (2/sqrt(pi)) sqrt((1 - rho/6)/nbar).
//
// In an open pipe n_K has no neighbour: K - 1 differences, scaled to K.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/gas/gas_window.hpp"
#include "cases/scene/gas_sampling.hpp"

namespace crossgrain::measure {

/// Series "contrast": t, C, err, and C_white for the density of that frame (0 from 6 particles per
/// site on). Measurements:
/// - `contrast_late`: mean of C/K over the last quarter of the frames, n replicas; settings
///   `white`, its white-noise value per bin, and `initial`, C/K of the first frame;
/// - `contrast_growth`: contrast_late minus C/K of the first frame, per replica;
/// - `contrast_grows`: share of the replicas whose late contrast exceeds the ensemble's first one;
/// - `contrast_excess`: contrast_late over its white-noise value, minus 1.
/// Nothing but the series if the run ended early. An empty pipe (nbar = 0) has C = 0.
class GasContrast final : public GasEstimator {
  public:
    /// Throws std::invalid_argument without the field `count`, or with fewer than three bins.
    explicit GasContrast(const scene::GasSampling& sampling);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    void measure(const scene::GasFrame& frame);

    scene::GasSampling sampling_;
    std::int64_t frame_ = 0;
    std::vector<double> contrast_, differences_, totals_;  ///< shape (replicas); C is C/K here
    std::vector<double> first_;
    GasWindow late_, late_density_;
    GasCurve curve_, white_curve_;
};

}  // namespace crossgrain::measure
