// Stagnant regions along the walls of a hopper of grains: up to which height the grains at the
// walls move with the flow, P_eps.
//
// The automaton's P, the highest wall grain that has ever moved, says nothing of real grains: they
// dilate, relax, and avalanche at the free surface, so that all of them move a little. P_eps is the
// height, over that of the walls, at which the mean velocity of the grains at the walls (along
// these, downward) first falls below eps times that on the centre line at the same height.
// Grains at a wall: those whose centre is within 1.5 d of the line through the wall grains'
// centres. Centre line: within 2 d of the axis.
#pragma once

#include "cases/measure/discharge/discharge_geometry.hpp"
#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"

#include <array>
#include <optional>
#include <vector>

namespace crossgrain::measure {

struct DischargeStagnationOptions {
    double from = 4, to = 20;
    double bin = 4;
    std::vector<double> shares = {0.1, 0.2, 0.3};
};

inline OptionKeys option_keys(DischargeStagnationOptions& o) {
    return {{"from", &o.from, Range::not_negative(), "start of the window (t)"},
            {"to", &o.to, Range::positive(), "end of the window (t), > from"},
            {"bin", &o.bin, Range::positive(), "of height, in diameters"},
            {"shares", &o.shares, Range::open(0, 1), "eps of moving_fraction_<eps>"}};
}

/// Measurements `moving_fraction_<eps>` for every eps, interpolated between the middles of the
/// bins, 1 if the velocity never falls below: mass flow. Error by the jackknife over four parts of
/// the window and two walls. Settings eps, from, to, half_angle (degrees). Series "wall-profile":
/// height (over that of the walls), ratio, wall, centre (velocities, l/t). Finding "state" = "mass
/// flow" if all are 1, else "funnel flow". Nothing if the run ends before the window (by more than
/// a frame), or if grains move too little to tell: fewer than two bins with 16 grains at the walls
/// and on the centre line, or a centre line that moves upward.
class DischargeStagnation final : public Estimator {
  public:
    using Options = DischargeStagnationOptions;
    /// Throws std::invalid_argument for a scene that is no hopper, and unless
    /// 0 <= from < to, bin > 0 and shares are in (0, 1).
    DischargeStagnation(const scene::Scene& scene, DischargeStagnationOptions options);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    static constexpr std::size_t quarters_ = 4, parts_ = 2 * quarters_;
    struct Sum {
        double n = 0, velocity = 0;
    };
    struct Bin {
        std::array<Sum, parts_> wall;  ///< quarters of the left wall, then of the right
        std::array<Sum, quarters_> centre;
    };
    struct Row {
        double height = 0, wall = 0, centre = 0;
        [[nodiscard]] double ratio() const { return wall / centre; }
    };
    /// Up to the first bin that has too few grains, without one part (parts_: with all).
    [[nodiscard]] std::vector<Row> profile(std::size_t left_out) const;
    [[nodiscard]] double moving_fraction(const std::vector<Row>& profile, double share) const;

    HopperWalls walls_;
    DischargeStagnationOptions options_;
    std::vector<Bin> bins_;
    double bin_ = 0;        ///< (l)
    double interval_ = 0;   ///< between frames (t)
    double last_time_ = 0;  ///< of the frames so far
};

}  // namespace crossgrain::measure
