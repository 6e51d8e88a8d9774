// Drift of the total momentum: pair forces obey Newton's third law whatever their form, so that
// P(t) - P(0) is nothing but round-off (or a defect of the code).
//
//   drift_a = max over frames |P_a(t) - P_a(0)| / max over frames sqrt(sum_i m_i^2 v_i^2)
//
// The scale is the momentum that N independent grains of the same kinetic energy would have by
// chance; it is not zero in the centre-of-mass frame.
#pragma once

#include "cases/measure/estimator.hpp"

namespace crossgrain::measure {

/// Measurements: `momentum_drift_x` (1), for every scene without frozen grains, drag and backing
/// planes (plates are smooth: they push along y only); `momentum_drift_y` (1), if there is neither
/// gravity nor a plate either. n is the number of frames. Nothing if all grains are always at rest
/// or there are fewer than two frames.
class Momentum final : public Estimator {
  public:
    explicit Momentum(const scene::Scene& scene);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    scene::Grains grains_;
    bool x_conserved_ = false;
    bool y_conserved_ = false;
    std::size_t frames_ = 0;
    double first_x_ = 0, first_y_ = 0;  ///< total momentum of the first frame
    double worst_x_ = 0, worst_y_ = 0;
    double scale_ = 0;
};

}  // namespace crossgrain::measure
