// How fast grains fall through a pipe, how hot they are, and whether they have reached a steady
// state: with smooth walls and without drag there is none (V = g t).
//
// V is the mean downward velocity of the mobile grains, phi V their flux with the area fraction phi
// in the clear pipe. The granular temperature is T = <|v - V_i|^2>/2 about the mean velocity V_i of
// the grain's bin in the same frame (n_i - 1 degrees of freedom per component), so that motion in a
// wave is none.
//
// Steady: of V, T and the variance of n_i along the pipe none drifts between the first and the last
// quarter of the frames by more than the tolerance (relative to their mean) and `sigmas` standard
// errors: the greater of those by blocking within the quarters (a quarter that itself drifts has
// none) and that of a straight line through eight block means. Pure drift has no error, and the
// tolerance decides.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/pipe/pipe_record.hpp"

#include <vector>

namespace crossgrain::measure {

struct PipeMotionOptions {
    PipeRecordOptions record;
    double tolerance = 0.05;
    double sigmas = 4;
};

inline OptionKeys option_keys(PipeMotionOptions& o) {
    return joined(
        option_keys(o.record),
        {{"tolerance", &o.tolerance, Range::positive(), "relative drift that still is steady"},
         {"sigmas", &o.sigmas, Range::positive(), "standard errors beyond which a drift counts"}});
}

/// Measurements, errors by blocking: `mean_speed` V (l/t), `flux` phi V (l/t), `area_fraction`
/// phi (exact), `granular_temperature` (l^2/t^2), `mean_square_spin` <omega^2> (1/t^2, only of
/// frames with spins), `drift_speed`, `drift_temperature`, `drift_variance`. Finding "state":
/// "steady" or "ageing". Series "motion": t, V, T (at most 1000 rows).
///
/// A mean whose blocks still drift is not reported. Nothing with fewer than 128 frames.
class PipeMotion final : public Estimator {
  public:
    using Options = PipeMotionOptions;
    /// Throws std::invalid_argument for a scene that is no pipe, fewer than 16 bins, and unless
    /// tolerance > 0 and sigmas > 0.
    PipeMotion(const scene::Scene& scene, PipeMotionOptions options);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    struct Drift {
        double value = 0, error = 0;  ///< relative
        bool beyond = false;
    };
    [[nodiscard]] double temperature(const scene::Frame& frame);
    [[nodiscard]] double variance() const;
    [[nodiscard]] Drift drift(std::span<const double> series) const;
    void append_state(Results& results) const;
    void append_series(Results& results) const;

    PipeMotionOptions options_;
    PipeSection section_;
    std::size_t bins_;
    std::vector<double> n_, vx_, vy_, vv_;  ///< sums by bin of the present frame
    std::vector<double> times_, speed_, temperature_, variance_, spin_;
};

}  // namespace crossgrain::measure
