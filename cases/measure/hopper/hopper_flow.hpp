// Flow rate out of a hopper against time and filling. Gremaud, section 3b and Fig. 8.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"

#include <span>
#include <vector>

namespace crossgrain::measure {

struct HopperFlowOptions {
    double down_to = 0.3;
};

inline OptionKeys option_keys(HopperFlowOptions& o) {
    return {{"down_to", &o.down_to, Range::open(0, 1),
             "filling above which the flow should not depend on it"}};
}

/// One angle; all from the last frame of each replica. Filling: grains left per site.
/// Measurements (mean and standard error over the replicas):
/// - flow_rate (grains per iteration): mean while the filling is above `down_to`;
/// - flow_exponent: d ln(rate)/d ln(filling) by least squares over the same time, in ten equal
///   stretches; 0 for a granular hopper, 1/2 or so for a fluid;
/// - filling_at_first_loss: filling when the rate first falls below N;
/// - residue: filling when the flow has ended (nothing for the last tenth of the run); absent while
///   it flows.
/// Finding "state" once the flow has ended: "ok" if the hopper is empty, "no meaning" if grains lie
/// on its walls for ever (any reach along these is then a matter of the iterations). Series "flow":
/// iteration, mean rate, its standard error, mean filling (thinned to 1000 rows).
class HopperFlow final : public HopperEstimator {
  public:
    using Options = HopperFlowOptions;
    /// Throws std::invalid_argument for more than one angle or an option out of range.
    explicit HopperFlow(const scene::HopperAutomaton& scene, HopperFlowOptions options = {});
    void add(const scene::HopperFrame& frame) override;
    void finish(Results& results) override;

  private:
    void append_state(std::span<const double> residues, Results& results) const;
    void append_series(Results& results) const;

    scene::HopperAutomaton scene_;
    HopperFlowOptions options_;
    double sites_ = 0;
    std::vector<std::vector<double>> flow_;  ///< shape (replicas, iterations)
};

}  // namespace crossgrain::measure
