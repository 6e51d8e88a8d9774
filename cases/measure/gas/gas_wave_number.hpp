// Spatial spectrum of the density along a pipe,
//
//   S(k) = < | sum_j (n_j - nbar) exp(-2 pi i j k/K) |^2 > / (K nbar),   k = 1..K/2,
//
// averaged over frames and replicas; 1 for particles without correlation (Poisson), k waves per
// pipe length. Its exponent is the log-log slope over k_min..k_max, standard error by the jackknife
// over replicas, systematic error half the spread over k_min..k_max, k_min..k_max/2 and 2
// k_min..k_max. An open pipe is no period: its S(k) holds the jump between its ends too.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/statistics/pair_transform.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::measure {

struct GasWaveNumberOptions {
    std::int64_t k_min = 1;
    std::int64_t k_max = 0;
    std::int64_t fields = 1000;
};

inline OptionKeys option_keys(GasWaveNumberOptions& o) {
    return {{"k_min", &o.k_min, Range::whole(1), "first k of the fit window"},
            {"k_max", &o.k_max, Range::whole(0),
             "last k, > k_min, at most half the bins; 0: a quarter"},
            {"fields", &o.fields, Range::whole(1), "most frames used, equally spaced"}};
}

/// Measurements: `wave_number_exponent` (slope of log S, -alpha_k; 0 without structure), settings
/// k_min, k_max; `wave_number`: k of the largest S, only if that is above 1.3 times the median of S
/// by five standard errors. Series "wave-numbers": k, S, err. Nothing if the run ended early.
class GasWaveNumber final : public GasEstimator {
  public:
    using Options = GasWaveNumberOptions;
    /// Throws std::invalid_argument without the field `count`, with fewer than 3 replicas or 16
    /// bins, and unless 1 <= k_min < k_max <= bins/2 and fields >= 1.
    GasWaveNumber(const scene::GasSampling& sampling, GasWaveNumberOptions options);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    void transform(const scene::GasFrame& frame, std::size_t replica);

    scene::GasSampling sampling_;
    GasWaveNumberOptions options_;
    std::size_t bins_, replicas_;
    std::int64_t frame_ = 0, stride_ = 1, used_ = 0;
    PairTransform transform_;
    std::vector<std::vector<double>> spectra_;  ///< sums, shape (replicas, K/2 + 1)
    std::vector<double> particles_;             ///< sums, shape (replicas)
};

}  // namespace crossgrain::measure
