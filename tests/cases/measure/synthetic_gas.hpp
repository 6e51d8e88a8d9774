// Ensembles of lattice gases made by hand, with a known answer, to calibrate estimators.
#pragma once

#include "cases/measure/results.hpp"
#include "cases/scene/gas_frame.hpp"
#include "cases/scene/gas_sampling.hpp"
#include "native/base/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace crossgrain::tests {

/// A frame that owns its arrays, filled bin by bin and replica by replica.
struct SyntheticGas {
    std::int64_t step = 0;
    std::size_t bins = 0, replicas = 0;
    std::vector<std::uint16_t> count, rests;
    std::vector<std::int16_t> momentum;
    std::vector<std::uint8_t> saturated;

    explicit SyntheticGas(const scene::GasSampling& sampling)
        : bins(static_cast<std::size_t>(sampling.bins())),
          replicas(static_cast<std::size_t>(sampling.replicas)), count(bins * replicas, 0),
          rests(sampling.fields.rests ? bins * replicas : 0, 0),
          momentum(sampling.fields.momentum ? bins * replicas : 0, 0) {}

    /// n(x, replica), rounded to whole particles.
    void fill(const std::function<double(std::size_t, std::size_t)>& n) {
        for (std::size_t i = 0; i < bins; ++i) {
            for (std::size_t r = 0; r < replicas; ++r) {
                count[i * replicas + r] =
                    static_cast<std::uint16_t>(std::lround(std::max(0.0, n(i, r))));
            }
        }
    }
    [[nodiscard]] scene::GasFrame view() const {
        return {step, bins, replicas, count, rests, momentum, saturated};
    }
};

/// Standard normal deviate number `n` of a seed.
inline double white(std::uint64_t seed, std::uint64_t n) {
    return normal_pair(seed, RandomStream::jitter, n / 2)[n % 2];
}

/// Feeds every frame of the sampling to an estimator; `fill` sets the frame for its step.
template <class Estimator>
measure::Results run_gas(const scene::GasSampling& sampling, Estimator& estimator,
                         const std::function<void(SyntheticGas&)>& fill) {
    SyntheticGas gas(sampling);
    for (std::int64_t f = 0; f < sampling.frames(); ++f) {
        gas.step = sampling.burn_in + f * sampling.every;
        fill(gas);
        estimator.add(gas.view());
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace crossgrain::tests
