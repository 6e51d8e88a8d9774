// Whether a gas has reached a steady state, decided statistically over the replicas: exponents and
// velocities of a run that still changes belong to its burn-in and length.
//
// Watched are the particles at rest (the kinetic energy is one per mover; Peng & Herrmann 1995,
// Fig. 3b), the contrast sum_i |n_i - n_{i+1}| (their Eq. 1), the variance of n_i along the pipe
// (the power at all wavelengths) and, in open pipes, the number of particles N. Drift is the mean
// over the last quarter of the frames minus that over the first, relative to their average.
//
// Labels of the finding "state", the first that holds:
// - "saturated": particles at rest exceeded the sites that can hold them;
// - "absorbing": in more than half of the replicas nothing has happened during the last quarter: N,
//   the particles at rest and the momentum are the same in all its frames (if the frames lack rests
//   or momentum: N, contrast and variance; a stream in free fall then passes unnoticed);
// - "clogged": an open pipe whose N grows from the second quarter to the third and from that to the
//   last, by more than the tolerance in all;
// - "ageing": some drift is beyond the tolerance and significant;
// - "steady".
// Significant: `sigmas` standard errors of the mean over the replicas.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace crossgrain::measure {

struct GasSteadyStateOptions {
    double tolerance = 0.05;
    double sigmas = 4;
};

inline OptionKeys option_keys(GasSteadyStateOptions& o) {
    return {
        {"tolerance", &o.tolerance, Range::positive(), "relative drift that still is steady"},
        {"sigmas", &o.sigmas, Range::positive(), "standard errors beyond which a drift counts"}};
}

/// Finding "state"; measurements `drift_rests`, `drift_contrast`, `drift_variance`, in open pipes
/// `drift_particles` (relative, only quantities that do not vanish), `absorbing_fraction` of the
/// replicas and, if any, `saturated_fraction`. Of a run that ended early without saturation,
/// nothing.
class GasSteadyState final : public GasEstimator {
  public:
    using Options = GasSteadyStateOptions;
    /// Throws std::invalid_argument without the field `count`, with fewer than 4 replicas, 16
    /// frames or 2 bins, and unless tolerance > 0 and sigmas > 0.
    GasSteadyState(const scene::GasSampling& sampling, GasSteadyStateOptions options);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    enum Quantity : std::size_t { particles, rests, momentum, contrast, variance, quantities };
    using Quarters = std::array<std::vector<double>, 4>;  ///< sums, each of shape (replicas)
    struct Drift {
        double value = 0, error = 0;  ///< relative
        bool beyond = false;          ///< the tolerance, significantly
    };

    void measure(const scene::GasFrame& frame);
    [[nodiscard]] Drift drift(Quantity quantity, std::size_t from, std::size_t to) const;
    [[nodiscard]] bool clogged() const;
    void add_saturation(Results& results) const;

    scene::GasSampling sampling_;
    GasSteadyStateOptions options_;
    std::size_t replicas_;
    std::int64_t frame_ = 0, saturated_step_ = 0;
    std::size_t saturated_ = 0;                                 ///< replicas
    std::array<std::vector<double>, quantities> now_, before_;  ///< of a frame
    std::array<Quarters, quantities> sums_;
    std::array<std::int64_t, 4> frames_in_{};
    std::vector<std::int64_t> last_change_;  ///< frame, by replica
};

}  // namespace crossgrain::measure
