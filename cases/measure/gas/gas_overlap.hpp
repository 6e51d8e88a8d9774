// Velocity of a density wave of a lattice gas by maximal overlap (overlap_velocity.hpp), every
// replica a sample. It is a wave if its speed is between v_min and v_max, up or down: particles in
// free fall carry every pattern along at v = 1. Seven intervals of white noise lie on a line with
// probability of about (40/512)^5 = 3e-6 for L = 512, 2e-4 for L = 220.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/waves/overlap_velocity.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
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

/// What OverlapVelocity appends, and `overlap_other_fraction`, the share of the replicas whose
/// pattern travels at another speed. Nothing if the run ended before the first reference was
/// followed to the largest lag.
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
    std::size_t replicas_;
    std::int64_t stride_ = 1;  ///< frames between references
    std::int64_t frames_, frame_ = 0, completed_ = 0;
    std::vector<std::size_t> lags_;  ///< frames, ascending
    OverlapVelocity overlap_;
    std::vector<float> reference_;
};

}  // namespace crossgrain::measure
