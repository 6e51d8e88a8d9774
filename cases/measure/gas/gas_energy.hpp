// Kinetic energy that a pipe loses to particles at rest (Peng & Herrmann 1995, section III.A,
// Fig. 3b). A moving particle has energy one, so E(0) - E(t) is the growth of the number at rest.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/gas/gas_window.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <optional>

namespace crossgrain::measure {

/// Series "energy-loss": t, (E(0) - E(t)) per site, err, with E(0) that of the first frame; for a
/// pipe with a fixed number of particles. Measurements:
/// - `rests_per_site`: particles at rest per site over the last quarter of the frames;
/// - `energy_loss_late`: the loss per site over the last quarter of the frames;
/// - `energy_loss_drift`: loss over the last quarter minus loss over the one before, over the
///   larger of the two in size; how far the loss still changes;
/// - `energy_loss_saturates`: share of the groups of replicas (8, or one per replica if fewer)
///   whose loss is positive and drifts by less than 5 %;
/// - `energy_saturation_time`: begin of the first of 50 equal stretches of the run from which on
///   every stretch has a group's late loss within 10 %, mean and error over the groups; absent if
///   the late loss of a group is not positive or its last stretch is off.
/// Nothing but the series if the run ended early.
class GasEnergy final : public GasEstimator {
  public:
    /// Throws std::invalid_argument without the field `rests`, or with fewer than eight frames.
    explicit GasEnergy(const scene::GasSampling& sampling);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    void add_saturation(Results& results) const;
    [[nodiscard]] std::optional<double> saturation_time(std::size_t group, double late) const;

    scene::GasSampling sampling_;
    std::int64_t frame_ = 0;
    std::vector<double> rests_, loss_, first_;  ///< shape (replicas), per site
    GasWindow third_, fourth_, fourth_rests_;
    GasCurve curve_;
    std::size_t groups_;
    std::vector<double> times_, group_loss_;  ///< shape (frames), (frames, groups)
};

}  // namespace crossgrain::measure
