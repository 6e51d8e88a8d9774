// Power spectrum of the density fluctuations in the bins of a pipe and its exponent
// (Peng & Herrmann 1995, section III.D, Figs. 6-10 and 12).
//
// The record of a bin is cut into segments of M fields that do not overlap. Each, minus its mean,
// is multiplied with the "Parzen" window of Numerical Recipes (1988), section 12.7,
//
//   w_j = 1 - |(j - (M-1)/2)/((M+1)/2)|
//
// (a triangle, nowadays Bartlett's), and
//
//   P(f_k) = 2 |sum_j w_j n_j exp(-2 pi i j k/M)|^2 / sum_j w_j^2,   f_k = k/M per interval,
//
// is averaged over segments, bins and samples; the integral of P over f is the variance of n.
//
// alpha: log_binned_slope.hpp over a window low..high, P ~ f^-alpha. Standard error: jackknife over
// the samples. Systematic error: half the spread over low..high, 2 low..high, low..high/2 and
// 2 low..high/2, as far as they hold three bins; what lies outside of the window may be a wave.
#pragma once

#include "cases/measure/results.hpp"
#include "cases/measure/statistics/log_binned_slope.hpp"
#include "cases/measure/statistics/pair_transform.hpp"
#include "cases/measure/waves/record_segments.hpp"

#include <map>
#include <string>
#include <vector>

namespace crossgrain::measure {

/// Of the series: what f is divided and P multiplied by, and what they are in.
struct SpectrumScale {
    double interval = 1;
    std::string frequency_unit, power_unit;
};

class BinSpectrum {
  public:
    /// `points` is M, even; `running_mean` > 1 (fields): subtracted over that many around each.
    BinSpectrum(BinRange bins, std::size_t samples, std::size_t points,
                std::size_t running_mean = 0);

    /// A full segment of these bins.
    void add(RecordSegments& segment);

    /// Appends `alpha` over the window (cycles per interval) with these settings, n the samples.
    /// Nothing if fewer than three bins of log f lie in it, or P vanishes there.
    void append_alpha(FrequencyWindow window, std::map<std::string, double> settings,
                      Results& results) const;

    /// Appends the series "spectrum": f, P and err (over the samples); every k up to 1024, then
    /// means of 8.
    void append_series(const SpectrumScale& scale, Results& results) const;

  private:
    [[nodiscard]] std::vector<double> mean() const;
    [[nodiscard]] double slope_error(const std::vector<double>& mean, FrequencyWindow window) const;

    BinRange bins_;
    std::size_t samples_, points_, running_mean_, segments_ = 0;
    PairTransform transform_;
    std::vector<float> window_;
    std::vector<double> power_;  ///< sums over bins and segments, shape (samples, M/2 + 1)
};

}  // namespace crossgrain::measure
