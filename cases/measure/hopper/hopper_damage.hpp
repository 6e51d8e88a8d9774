// Damage spreading: how far a hopper and its twin, which starts with a few nodes flipped, part.
// Gremaud, section 3c, Experiment 2 and Fig. 12.
#pragma once

#include "cases/measure/estimator.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace crossgrain::measure {

/// One angle, a scene with `flipped` > 0. Damage: share of all sites whose state differs.
/// Measurements (mean and standard error over the replicas, each a trial):
/// - damage: at the end;
/// - damaged_trials: share of trials with damage above 1 % at the end;
/// - shape_difference: sites emptied in one of the two only, per site emptied in either: how far
/// the
///   global shapes part.
/// Series "damage": iteration, mean damage, its standard error, share of damaged trials.
class HopperDamage final : public HopperEstimator {
  public:
    /// Throws std::invalid_argument for more than one angle or a scene without a twin.
    explicit HopperDamage(const scene::HopperAutomaton& scene);
    void add(const scene::HopperFrame& frame) override;
    void finish(Results& results) override;

  private:
    std::size_t replicas_;
    std::map<std::int64_t, std::vector<double>> damage_;  ///< by iteration, shape (replicas)
    std::vector<double> shape_difference_;                ///< shape (replicas)
};

}  // namespace crossgrain::measure
