// Stagnant regions along the walls of a hopper: P(theta), its power law and its critical angle.
// Gremaud, "Numerical simulation of pattern formation in grain flows", section 3a and Fig. 7.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/hopper/hopper_stagnation_law.hpp"
#include "cases/measure/options.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::measure {

struct HopperStagnationOptions {
    std::vector<std::int64_t> at = {};
    std::optional<double> profile_at = {};
};

inline OptionKeys option_keys(HopperStagnationOptions& o) {
    return {{"at", &o.at, Range::whole(1),
             "iterations, frames of the scene; the first gives the plain names, the others "
             "..._at_<iteration>; left out: the last"},
            {"profile_at",
             &o.profile_at,
             {},
             "angle of the wall's profile (degrees); runs within half a degree count; left out: "
             "none"}};
}

/// P = mean over both walls of (k + 1)/L, k the highest half-level whose outermost site was ever
/// vacated; 1/P = b theta^a beyond a critical angle.
///
/// Measurements, each from every replica's own P(theta), then mean and standard error over four or
/// more replicas (fewer: bootstrap over the angles):
/// - exponent_<fit>_<from>_<to>, a over 10-90, 13-90, 20-90 and 30-90 degrees; <fit> is
///   "unweighted" (least squares of 1/P) or "log" (of ln 1/P), or the same with "tan_" in front:
///   exponents in tan(theta/2);
/// - critical_angle (degrees): width of the angles with P >= 0.99, above the lowest one;
/// systematic:
///   half the difference between the thresholds 0.98 and 0.998;
/// - critical_angle_fit (degrees): where the log fit over 20-90 degrees reaches P = 1;
/// - moving_fraction: P of a scene of one angle, else mean of P over the angles up to 12 degrees,
///   where the paper sees mass flow; moving_fraction_left and _right.
/// Series "wall-profile" (height, moved, standard_error): the share of walls that have moved at a
/// height in units of the wall, at the first iteration. Series "stagnation" (theta, iteration,
/// left, right, P, standard_error) and, with a power law, "stagnation-fits" (theta, 1/P, both fits
/// over 13-90, the experiment's exponents 2.1 and 2.3 through the log fit's mid-point). Finding
/// "state" = "no meaning" beyond 120 degrees, where no moving_fraction is given.
class HopperStagnation final : public HopperEstimator {
  public:
    using Options = HopperStagnationOptions;
    /// Throws std::invalid_argument for an iteration that is no frame of the scene, or a profile of
    /// an angle that it does not have.
    explicit HopperStagnation(const scene::HopperAutomaton& scene,
                              HopperStagnationOptions options = {});
    void add(const scene::HopperFrame& frame) override;
    void finish(Results& results) override;

    /// P of both walls of one run.
    struct Walls {
        double left = 0, right = 0;
        [[nodiscard]] double mean() const noexcept { return (left + right) / 2; }
    };

  private:
    /// P of each replica.
    [[nodiscard]] std::vector<AngleSweep> sweeps(std::int64_t iteration) const;
    [[nodiscard]] bool complete(std::int64_t iteration) const;
    void append_at(std::int64_t iteration, Results& results) const;
    void append_moving_fraction(std::int64_t iteration, const std::string& suffix,
                                Results& results) const;
    void append_exponents(std::int64_t iteration, const std::string& suffix,
                          Results& results) const;
    void append_critical_angles(std::int64_t iteration, const std::string& suffix,
                                Results& results) const;
    void append_series(Results& results) const;
    void append_fits(Results& results) const;
    void append_profile(double angle, Results& results) const;

    scene::HopperAutomaton scene_;
    std::vector<std::int64_t> at_;
    std::optional<double> profile_at_;
    /// By iteration, shape (angles, replicas).
    std::map<std::int64_t, std::vector<Walls>> walls_;
    std::map<std::int64_t, std::size_t> seen_;
};

}  // namespace crossgrain::measure
