// Velocity of density waves from the correlation of two places (Peng & Herrmann 1995, Eq. 2,
// Fig. 11b),
//
//   C(R, T) = sum_{i,t} n_i(t) n_{i+R}(t + T),
//
// here the mean over i and over reference frames t instead of the sum. With its maximum at T_c,
// v = R delta/T_c, delta the length of a bin.
//
// C may rise or fall slowly as well, when the whole pipe changes; so the maximum is the local one,
// between the T of v_max and of v_min, that stands highest above the lower ground on both of its
// sides (the larger of the two minima): its prominence. It is a wave if that is at least 6 standard
// errors, over the replicas, of this difference. T_c is the centroid of C above half the
// prominence. If asked for, the mean over `running_mean` frames around each frame is subtracted
// from n_i first.
#pragma once

#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"
#include "cases/scene/gas_sampling.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::measure {

struct GasCorrelationOptions {
    std::int64_t separation = 30;
    double v_min = 0.15;
    double v_max = 0.6;
    std::int64_t running_mean = 0;
    std::int64_t references = 500;
};

inline OptionKeys option_keys(GasCorrelationOptions& o) {
    return {
        {"separation", &o.separation, Range::whole(1), "R in bins"},
        {"v_min", &o.v_min, Range::positive(), "least speed of a wave, sites per step"},
        {"v_max", &o.v_max, Range::positive(), "largest speed of a wave, > v_min"},
        {"running_mean", &o.running_mean, Range::whole(0), "frames, made odd; 0: none"},
        {"references", &o.references, Range::whole(1), "most reference frames, equally spaced"}};
}

/// Series "correlation": T and C, from T = 0 on. If a wave is found:
/// `correlation_time` T_c (steps) and `correlation_velocity`, settings separation and sigmas;
/// errors by the jackknife over 16 groups of replicas. Nothing if the run ends before the first
/// reference was followed to the largest T.
class GasCorrelation final : public GasEstimator {
  public:
    using Options = GasCorrelationOptions;
    /// Throws std::invalid_argument without the field `count`, with fewer than 16 replicas, a
    /// separation beyond the pipe, fewer than 8 frames between the T of v_max and of v_min, or a
    /// run that is too short.
    GasCorrelation(const scene::GasSampling& sampling, GasCorrelationOptions options);
    void add(const scene::GasFrame& frame) override;
    void finish(Results& results) override;

  private:
    struct Reference {
        std::int64_t frame = -1;
        std::vector<float> field;  ///< shape (bins, replicas)
    };
    struct Maximum {
        std::size_t lag = 0;     ///< of the maximum
        std::size_t ground = 0;  ///< lag of the larger of the minima beside it
        double prominence = 0;
    };

    void add_field(std::int64_t frame);
    void correlate(const Reference& reference, std::size_t lag);
    [[nodiscard]] std::vector<double> curve(std::size_t first, std::size_t last) const;
    [[nodiscard]] std::vector<double> curve_without(std::size_t first, std::size_t last) const;
    [[nodiscard]] std::optional<Maximum> maximum(const std::vector<double>& curve) const;
    [[nodiscard]] static double centroid(const std::vector<double>& curve, const Maximum& maximum);
    [[nodiscard]] double prominence_error(const Maximum& maximum) const;
    void add_wave(const std::vector<double>& curve, Results& results) const;

    scene::GasSampling sampling_;
    GasCorrelationOptions options_;
    std::size_t bins_, replicas_, separation_;
    std::size_t lag_min_, lag_max_;                   ///< frames
    std::int64_t frame_ = 0, stride_ = 1;             ///< frames between references
    std::vector<std::vector<std::uint16_t>> recent_;  ///< ring of `running_mean` frames
    std::vector<std::uint32_t> sum_;                  ///< over the ring, shape (bins, replicas)
    std::vector<float> field_;
    std::vector<Reference> active_;  ///< ring
    std::vector<double> sums_;       ///< shape (lags, replicas)
    std::int64_t completed_ = 0;     ///< references followed to the largest lag
};

}  // namespace crossgrain::measure
