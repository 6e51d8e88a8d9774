// Spatial spectrum of the density of grains along a periodic pipe, from their positions,
//
//   n_k = sum_j exp(-2 pi i k y_j/L),   S(k) = <|n_k|^2>/N,   k = 1, 2, ... waves per pipe,
//
// 1 for grains without correlation. Its exponent is the log-log slope over k_min..k_max, standard
// error by the jackknife over eight parts of the run, systematic error half the spread over
// k_min..k_max, k_min..k_max/2 and 2 k_min..k_max. It depends on a window, but on no bin and no
// interval between frames, which the exponent in time does.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/pipe/pipe_section.hpp"

#include <cstdint>
#include <vector>

namespace crossgrain::measure {

struct PipeStructureOptions {
    double skip = 0;
    std::int64_t k_min = 1;
    std::int64_t k_max = 7;
};

inline OptionKeys option_keys(PipeStructureOptions& o) {
    return {{"skip", &o.skip, Range::not_negative(), "frames before this time (t) are left out"},
            {"k_min", &o.k_min, Range::whole(1, 64), "first k of the fit window"},
            {"k_max", &o.k_max, Range::whole(1, 64), "last k of that window, > k_min"}};
}

/// Measurements: `wave_number_exponent` (0 without structure, negative for waves), settings k_min
/// and k_max; `structure_factor` S(k_min), error by blocking; `wave_number`, the k of the largest
/// S. Series "wave-numbers": k, S, err, up to the larger of 32 and k_max. Nothing with fewer than
/// 128 frames.
class PipeStructure final : public Estimator {
  public:
    using Options = PipeStructureOptions;
    /// Throws std::invalid_argument for a scene that is no pipe, and unless
    /// 1 <= k_min < k_max <= 64.
    PipeStructure(const scene::Scene& scene, PipeStructureOptions options);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    [[nodiscard]] std::vector<std::vector<double>> block_means() const;
    void append_exponent(const std::vector<std::vector<double>>& blocks, Results& results) const;

    PipeSection section_;
    PipeStructureOptions options_;
    std::vector<std::vector<double>> power_;  ///< |n_k|^2/N, shape (k, frames); k = 0 stays empty
};

}  // namespace crossgrain::measure
