// Spatial spectrum of the density along a pipe,
//
//   S(k) = < | sum_j (n_j - nbar) exp(-2 pi i j k/K) |^2 > / (K nbar),   k = 1..K/2 waves per pipe,
//
// averaged over fields and samples; 1 for particles without correlation (Poisson). Its exponent is
// the log-log slope over k_min..k_max, standard error by the jackknife over the samples, systematic
// error half the spread over k_min..k_max, k_min..k_max/2 and 2 k_min..k_max. A bin of length b
// damps what is above 1 by sinc^2(k/K): k_max must be well below K. An open pipe is no period: its
// S(k) holds the jump between its ends too.
#pragma once

#include "cases/measure/results.hpp"
#include "cases/measure/statistics/pair_transform.hpp"
#include "cases/measure/waves/binned_record.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace crossgrain::measure {

/// The window of the exponent, 1 <= min < max <= bins/2.
struct WaveNumbers {
    std::int64_t min = 1, max = 0;
};

class StructureFactor {
  public:
    /// Throws std::invalid_argument for fewer than 3 samples or 16 bins and for a window out of
    /// range.
    StructureFactor(FieldShape shape, WaveNumbers window);

    /// A field of counts.
    void add(std::span<const std::uint16_t> counts);

    /// Appends `wave_number_exponent` (0 without structure, negative for waves), settings k_min and
    /// k_max; `wave_number`, the k of the largest S, if that is above 1.3 times the median of S by
    /// Student's t of the samples at 0.001 over all k; the series "wave-numbers": k, S, err.
    void append(Results& results) const;

  private:
    /// S(k) of each sample, shape (samples); nothing without particles.
    [[nodiscard]] std::vector<double> at(std::size_t k) const;
    void transform(std::span<const std::uint16_t> counts, std::size_t sample);

    FieldShape shape_;
    WaveNumbers window_;
    PairTransform transform_;
    std::vector<std::vector<double>> spectra_;  ///< sums, shape (samples, K/2 + 1)
    double particles_ = 0;                      ///< of all fields, mean over the samples
};

}  // namespace crossgrain::measure
