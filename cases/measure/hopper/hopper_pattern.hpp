// Orientation patterns in a hopper: correlation lengths, fractions, velocity, left-right asymmetry.
// Gremaud, section 3c, Experiments 1 and 3.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/hopper/hopper_orientation_box.hpp"
#include "cases/measure/options.hpp"

#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace crossgrain::measure {

struct HopperPatternOptions {
    double half_width = 25;
    double from = 60, to = 220;
    std::int64_t lag = 10;
    std::int64_t window = 100;
};

inline OptionKeys option_keys(HopperPatternOptions& o) {
    return {
        {"half_width", &o.half_width, Range::positive(),
         "of the box |x| <= half_width, in spacings"},
        {"from", &o.from, Range::not_negative(), "lower end of the box, in spacings"},
        {"to", &o.to, Range::positive(), "upper end of the box, > from"},
        {"lag", &o.lag, Range::whole(1),
         "iterations between the two times of the velocity, a multiple of those between frames"},
        {"window", &o.window, Range::whole(0),
         "iterations before the end over which the velocity is averaged"}};
}

/// One angle. Correlations are those of hopper_orientation_box.hpp, of the last frame of each
/// replica. Measurements (mean and standard error over the replicas):
/// - neighbour_correlation g1, correlation_length_x and _y (spacings, where G falls to 1/e;
/// settings
///   "bounded": replicas in which it does not within the box, taken at the largest separation;
///   "uniform": replicas whose box holds one orientation only, left out);
/// - horizontal_share: share of replicas whose pattern is longer along x than along y;
/// - vertical_fraction, of the grains in the box;
/// - pattern_velocity (spacings per iteration, up positive): shift of the highest space-time
///   correlation over `lag`, and the same of vertical grains alone (pattern_velocity_vertical) and
///   of the two others (pattern_velocity_slanted); rising_share, _vertical and _slanted: share of
///   replicas with an upward velocity. Only for a pattern: g1 and the highest space-time
///   correlation at least 0.1 in every replica;
/// - asymmetry: |left - right|/(left + right) of the emptied sites of the whole hopper;
/// - mirror_imbalance_sites: (left - right)/(left + right) of them, and mirror_imbalance_grains:
///   (n_1 - n_3)/(n_1 + n_3) of the grains slanted to either side in the whole hopper (0 without
///   any). The rules have no left and right (orientations 1 and 3 are mirror images): the mean over
///   replicas is 0, however lopsided a single one is.
/// Series "orientation-correlation-x" and "-y": separation, G.
/// Finding "state" up to 120 degrees (beyond, HopperStagnation's "no meaning"): "asymmetric" if the
/// asymmetry exceeds 0.2; "structureless" if g1 < 0.1; "bands" if the pattern is longer along x
/// than along y; else "patches", as also when all boxes are uniform.
class HopperPattern final : public HopperEstimator {
  public:
    using Options = HopperPatternOptions;
    /// Throws std::invalid_argument for more than one angle, an empty box, or a lag that is no
    /// multiple of the frames' distance or longer than the run.
    explicit HopperPattern(const scene::HopperAutomaton& scene, HopperPatternOptions options = {});
    void add(const scene::HopperFrame& frame) override;
    void finish(Results& results) override;

  private:
    struct Replica {
        std::deque<OrientationBox> past;  ///< the frames of the last `lag` iterations
        SpaceTimeCounts counts;
    };
    /// What one replica yields.
    struct Outcome {
        std::optional<PatternShape> shape;  ///< nothing for a uniform box
        std::optional<double> vertical_fraction;
        double emptied_imbalance = 0, slant_imbalance = 0;
        PatternShift shift;
    };
    /// Those of replicas that are not uniform.
    [[nodiscard]] std::vector<PatternShape> shapes() const;
    /// Whether every replica that is not uniform has a pattern that lasts over the lag.
    [[nodiscard]] bool has_pattern() const;
    void append_velocities(Results& results) const;
    void append_shapes(Results& results) const;
    void append_state(Results& results) const;

    HopperPatternOptions options_;
    scene::HopperAutomaton scene_;
    std::map<int, Replica> running_;
    std::vector<Outcome> outcomes_;
};

}  // namespace crossgrain::measure
