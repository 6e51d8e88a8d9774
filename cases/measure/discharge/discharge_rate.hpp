// Mass flowing out of a hopper of grains against time and filling, and whether it is constant, as
// it is of grains and is not of a fluid (Gremaud, section 3b; Beverloo, Leniger & van de Velde,
// Chem. Eng. Sci. 15, 260 (1961)).
//
// A grain is out once its centre is below the outlet. The filling height is that at which the
// hopper would hold the remaining mass as loosely as at the start (98 of 100 grains are below the
// initial height): the free surface of a funnel has no one height of its own.
#pragma once

#include "cases/measure/discharge/discharge_geometry.hpp"
#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"

#include <optional>
#include <vector>

namespace crossgrain::measure {

struct DischargeRateOptions {
    double from = 8;
    std::optional<double> to = {};
    double down_to = 0.3;
};

inline OptionKeys option_keys(DischargeRateOptions& o) {
    return {{"from", &o.from, Range::not_negative(),
             "start of the window (t): the start of the flow before it is left out"},
            {"to", &o.to, Range::positive(), "end of the window (t), > from; left out: of the run"},
            {"down_to", &o.down_to, Range::right_open(0, 1),
             "the window ends when less than this share of the mass is left"}};
}

/// Measurements over the window:
/// - `flow_rate` (m/t), error from the scatter of ten equal stretches;
/// - `flow_rate_drift`: change over the window by a straight line through the stretches, relative;
/// - `flow_rate_halves`: second half over first half, minus 1;
/// - `flow_exponent`: d ln(rate)/d ln(filling height) over the stretches, 0 for grains, 1/2 for a
///   fluid; only if the height changes by 10 % or more.
/// Settings from, to, outlet, half_angle (degrees). Series "discharge": t (middle), discharged,
/// rate, height, of 50 stretches of the whole run. Finding "flow": "jammed" if nothing comes out
/// for a fifth of the window or more, "steady" if the halves differ by less than 3 % or three
/// errors, else "changing". Nothing if the window has fewer than 20 frames or no grain comes out in
/// it.
class DischargeRate final : public Estimator {
  public:
    using Options = DischargeRateOptions;
    /// Throws std::invalid_argument for a scene that is no hopper or a window that is none.
    DischargeRate(const scene::Scene& scene, DischargeRateOptions options);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    struct Stretch {
        double time = 0, discharged = 0, rate = 0, height = 0;  ///< of its middle
    };
    [[nodiscard]] double filling_height(double discharged) const;
    [[nodiscard]] std::vector<Stretch> stretches(std::size_t first, std::size_t last,
                                                 std::size_t count) const;
    void append_rate(std::size_t first, std::size_t last, Results& results) const;
    void append_state(const std::vector<Stretch>& parts, double halves, double error,
                      Results& results) const;
    void append_series(Results& results) const;

    HopperWalls walls_;
    DischargeRateOptions options_;
    std::vector<double> masses_;  ///< of the mobile grains
    double total_ = 0, initial_area_ = 0;
    std::vector<double> times_, discharged_;
};

}  // namespace crossgrain::measure
