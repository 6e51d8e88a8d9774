// Spectrum, exponent and waves of a lattice gas: every replica is a sample of bin_spectrum.hpp and
// mode_spectrum.hpp (Peng & Herrmann 1995, section III.D, Figs. 6-10 and 12).
//
// A wave is looked for between v_min and v_max: above lie free fall (v = 1) and harmonics, below
// the background of slow changes. The fit window of alpha is cut off at 0.7 of the wave's
// frequency.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/waves/bin_spectrum.hpp"
#include "cases/measure/waves/mode_spectrum.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
#include <optional>

namespace crossgrain::measure {

struct GasSpectrumOptions {
    std::int64_t segments = 4;
    std::int64_t points = 16384;
    double f_min = 1e-3;
    double f_max = 1e-2;
    double v_min = 0.15;
    double v_max = 0.6;
    std::int64_t running_mean = 0;
    std::int64_t first_bin = 0;
    std::int64_t last_bin = -1;
};

inline OptionKeys option_keys(GasSpectrumOptions& o) {
    return {{"segments", &o.segments, Range::whole(1), "S"},
            {"points", &o.points, Range::whole(64), "M of a segment, even"},
            {"f_min", &o.f_min, Range::open(0, 0.25), "start of the fit window, cycles per record"},
            {"f_max", &o.f_max, Range::left_open(0, 0.5), "end of that window, > 2 f_min"},
            {"v_min", &o.v_min, Range::positive(), "least speed of a wave, sites per step"},
            {"v_max", &o.v_max, Range::positive(), "largest speed of a wave, > v_min"},
            {"running_mean", &o.running_mean, Range::whole(0),
             "records around each whose mean is subtracted, < points; 0: none"},
            {"first_bin", &o.first_bin, Range::whole(0), "of the bins looked at, from the top"},
            {"last_bin", &o.last_bin, Range::whole(-1), "of those bins; -1: the last of the pipe"}};
}

/// Measurements:
/// - `alpha`, settings f_min, f_max, segments, points, running_mean;
/// - in periodic pipes of nine bins or more that are all looked at: `wave_fraction`, share of the
///   replicas that have a wave of their own, and `wave_velocity` (along gravity) of the ensemble.
/// Series "spectrum". Nothing if the run ends before S M frames.
class GasSpectrum final : public GasEstimator {
  public:
    using Options = GasSpectrumOptions;
    /// Throws std::invalid_argument unless segments >= 1, points >= 64 and even,
    /// 0 < 2 f_min < f_max <= 0.5, 0 < v_min < v_max, 0 <= running_mean < points and
    /// 0 <= first_bin <= last_bin < bins; without the field `count`, or
    /// if the run has fewer than S M frames.
    GasSpectrum(const scene::GasSampling& sampling, GasSpectrumOptions options);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    GasSpectrumOptions options_;
    std::size_t replicas_;
    RecordSegments segments_;
    BinSpectrum bins_;
    std::optional<ModeSpectrum> modes_;
    std::int64_t done_ = 0;  ///< segments
};

}  // namespace crossgrain::measure
