// Power spectrum of the density fluctuations in the bins of a pipe, its exponent, and the velocity
// of density waves (Peng & Herrmann 1995, section III.D, Figs. 6-10 and 12).
//
// The record of a bin is cut into S segments of M frames that do not overlap. Each, minus its mean,
// is multiplied with the "Parzen" window of Numerical Recipes (1988), section 12.7,
//
//   w_j = 1 - |(j - (M-1)/2)/((M+1)/2)|
//
// (a triangle, nowadays Bartlett's), and
//
//   P(f_k) = 2 |sum_j w_j n_j exp(-2 pi i j k/M)|^2 / sum_j w_j^2,   f_k = k/M per record,
//
// is averaged over segments, bins and replicas; the integral of P over f is the variance of n.
//
// alpha: log_binned_slope.hpp over the window f_min..f_max, cut off at 0.7 of the wave's frequency
// if a wave is found below f_max/0.7. Standard error: jackknife over replicas. Systematic error:
// half the spread over the windows f_min/2..f_max, f_min..f_max, 2 f_min..f_max, f_min/2..f_max/2
// and f_min..f_max/2.
//
// v = L f/T0, T0 the steps between records: the peak of spectrum_peak.hpp between v_min and v_max;
// above lie free fall (v = 1) and harmonics, below the background of slow changes. Standard error:
// jackknife over up to 16 groups of replicas (a weak peak stands out of all of them, not of one);
// systematic error: half of a frequency step.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/gas/gas_segments.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/statistics/log_binned_slope.hpp"
#include "cases/measure/statistics/pair_transform.hpp"
#include "cases/measure/statistics/spectrum_peak.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
#include <optional>
#include <vector>

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
/// - `alpha`, settings f_min, f_max, segments, points;
/// - in periodic pipes `wave_fraction`: share of the replicas with a significant peak;
///   `wave_velocity`: of the ensemble's spectrum, only if its peak is significant, settings
///   peak_ratio (over the background) and peak_sigmas.
/// Series "spectrum": f, P and err (over replicas); every k up to 1024, then means of 8.
/// Nothing if the run ends before S M frames; no alpha if P vanishes in the window; no wave if the
/// band of velocities is beyond the spectrum or at its very first frequencies.
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
    void transform_segment();
    [[nodiscard]] std::vector<double> spectrum(std::size_t first, std::size_t last) const;
    [[nodiscard]] PeakSearch peak_search() const;
    [[nodiscard]] double velocity(double k) const;
    [[nodiscard]] std::optional<SpectrumPeak> add_wave(const std::vector<double>& mean,
                                                       Results& results) const;
    [[nodiscard]] double velocity_error(const std::vector<double>& mean) const;
    void add_alpha(const std::vector<double>& mean, double f_max, Results& results) const;
    [[nodiscard]] double alpha_error(const std::vector<double>& mean, FrequencyWindow window) const;
    void add_series(const std::vector<double>& mean, Results& results) const;

    scene::GasSampling sampling_;
    GasSpectrumOptions options_;
    std::size_t replicas_, points_;
    GasSegments segments_;
    PairTransform transform_;
    std::vector<float> window_;
    double normalisation_ = 0;   ///< from sums of squares to P
    std::vector<double> power_;  ///< sums over bins and segments, shape (replicas, M/2 + 1)
    std::int64_t done_ = 0;      ///< segments
};

}  // namespace crossgrain::measure
