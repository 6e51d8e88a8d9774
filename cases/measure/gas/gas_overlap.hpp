// Velocity of a density wave in real space by maximal overlap (Peng & Herrmann 1995, section III.C,
// Fig. 5): from a reference field on, the shift at which a later field overlaps it most grows as
// v T with the time interval T.
//
// Fields are first averaged over about 20 sites: otherwise single particles in free fall decide
// the overlap. For each replica the overlap functions of all references are added, the shift of
// their maximum is followed over the intervals (unwrapped around the pipe), and v is the slope of
// the straight line through the shifts, intercept free.
//
// Whether a pattern travels is decided by shift_line.hpp. Shifts of white noise are uniform on the
// pipe; seven intervals and L = 512 pass with probability (40/512)^6 < 1e-6, L = 220 with 4e-5. It
// is a wave if its speed is between v_min and v_max, up or down: particles in free fall carry every
// pattern along at v = 1.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/gas/gas_shift.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/statistics/shift_line.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace crossgrain::measure {

struct GasOverlapOptions {
    double lag_min = 80;
    double lag_max = 320;
    double lag_step = 40;
    double smoothing = 20;
    double v_min = 0.15;
    double v_max = 0.6;
    std::int64_t references = 200;
};

inline OptionKeys option_keys(GasOverlapOptions& o) {
    return {
        {"lag_min", &o.lag_min, Range::positive(), "shortest lag in steps, rounded to frames"},
        {"lag_max", &o.lag_max, Range::positive(), "longest lag in steps, > lag_min"},
        {"lag_step", &o.lag_step, Range::positive(), "between lags, in steps"},
        {"smoothing", &o.smoothing, Range::positive(), "of the fields, in sites"},
        {"v_min", &o.v_min, Range::not_negative(), "least speed of a wave, sites per step"},
        {"v_max", &o.v_max, Range::positive(), "largest speed of a wave, > v_min"},
        {"references", &o.references, Range::whole(1), "most reference fields, equally spaced"}};
}

/// Series "overlap": T, shift and err (sites; mean over the replicas with a wave, of all replicas
/// if none has), height (overlap at its maximum over that of the reference with itself, all
/// replicas). Measurements:
/// - `overlap_wave_fraction`: share of the replicas with a wave;
/// - `overlap_other_fraction`: share of those whose pattern travels at another speed;
/// - `overlap_velocity`: sites per step along gravity, over the replicas with a wave (n of them);
///   absent if fewer than two have one. Settings lag_min, lag_max, smoothing, references, share
///   (of the replicas).
/// Nothing if the run ended before the first reference was followed to the largest lag.
class GasOverlap final : public GasEstimator {
  public:
    using Options = GasOverlapOptions;
    /// Throws std::invalid_argument for an open pipe, without the field `count`, fewer than three
    /// lags, no range of speeds, a smoothing of half the pipe or more, or a run shorter than
    /// lag_max.
    GasOverlap(const scene::GasSampling& sampling, GasOverlapOptions options);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    [[nodiscard]] std::vector<double> shifts(std::size_t replica) const;
    [[nodiscard]] ShiftLine line_through(const std::vector<double>& shifts) const;
    [[nodiscard]] double height(std::size_t lag) const;

    scene::GasSampling sampling_;
    GasOverlapOptions options_;
    FieldShape shape_;
    std::vector<std::int64_t> lags_;  ///< frames, ascending
    std::size_t rows_;                ///< bins of the smoothing
    std::int64_t stride_;             ///< frames between references
    std::int64_t frame_ = 0, completed_ = 0;
    std::vector<float> reference_, pending_;  ///< pending_: overlaps of the present reference
    std::vector<float> overlaps_;             ///< of all, shape (1 + lags, bins, replicas)
};

}  // namespace crossgrain::measure
