// Number of particles in an open pipe, and whether it clogs (Peng & Herrmann 1995, section III.I,
// Fig. 12c): below the critical injection rate N(t) is constant once the empty pipe has filled,
// above it N(t) goes on growing.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/gas/gas_window.hpp"
#include "cases/measure/options.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <optional>

namespace crossgrain::measure {

struct GasTotalOptions {
    double margin = 0.1;
};

inline OptionKeys option_keys(GasTotalOptions& o) {
    return {{"margin", &o.margin, Range::positive(),
             "growth of N over its first plateau from which on a replica is clogged"}};
}

/// The plateau is the mean of N over the steps 4 L to 6 L (particles fall at more than L/4 per L
/// steps, so the pipe has filled by then; from the first frame on if that is later), the late value
/// the mean over the last quarter of the frames, or the last frame if the run ended early.
/// Series "number": t, N, err. Measurements:
/// - `number_plateau`, `number_late`: particles;
/// - `number_growth`: late over plateau, minus 1, per replica;
/// - `clogged_fraction`: share of the replicas that grew by more than the margin, or whose
///   particles at rest exceeded the free sites;
/// - `outflow`: particles per step through the last bin, mean over the last quarter of the frames
///   (absent without the field `momentum`).
class GasTotal final : public GasEstimator {
  public:
    using Options = GasTotalOptions;
    /// Throws std::invalid_argument for a periodic pipe, a margin that is not positive, without the
    /// field `count`, or for a run that ends before 12 L (a plateau, and something after it).
    GasTotal(const scene::GasSampling& sampling, GasTotalOptions options);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    scene::GasSampling sampling_;
    GasTotalOptions options_;
    std::int64_t frame_ = 0;
    std::vector<double> number_, outflow_;  ///< shape (replicas)
    std::vector<std::uint8_t> saturated_;
    GasWindow plateau_, late_, late_outflow_;
    GasCurve curve_;
};

}  // namespace crossgrain::measure
