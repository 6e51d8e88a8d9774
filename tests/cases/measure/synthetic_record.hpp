// Binned records made by hand, with a known answer, to calibrate the estimators of waves.
#pragma once

#include "cases/measure/statistics/pair_transform.hpp"
#include "cases/measure/waves/binned_record.hpp"
#include "cases/measure/waves/record_segments.hpp"
#include "native/base/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

namespace crossgrain::tests {

/// Two independent Gaussian series of unit variance with P(f) ~ f^-alpha: a quarter of a period of
/// random Fourier coefficients (Timmer & Koenig, A&A 300, 707 (1995)).
inline std::array<std::vector<double>, 2> coloured(std::size_t points, double alpha,
                                                   std::uint64_t seed) {
    const std::size_t n = 4 * points;
    measure::PairTransform transform(n);
    double variance = 0;
    for (std::size_t k = 1; k < n; ++k) {
        const double amplitude = std::pow(static_cast<double>(std::min(k, n - k)), -alpha / 2);
        const auto [a, b] = normal_pair(seed, RandomStream::jitter, k);
        transform.input()[k] = std::complex<float>(std::complex<double>(a, b) * amplitude);
        variance += amplitude * amplitude;
    }
    transform.input()[0] = 0;
    transform.forward();
    std::array<std::vector<double>, 2> series{std::vector<double>(points),
                                              std::vector<double>(points)};
    for (std::size_t t = 0; t < points; ++t) {
        const auto [real, imaginary] = transform.at(t);
        const auto z = real + std::complex<float>(0, 1) * imaginary;
        series[0][t] = double{z.real()} / std::sqrt(variance);
        series[1][t] = double{z.imag()} / std::sqrt(variance);
    }
    return series;
}

/// A pipe of unit bins and unit intervals whose counts are 1000 + noise, independent in each bin
/// and sample, + waves.
class SyntheticRecord {
  public:
    SyntheticRecord(measure::FieldShape shape, std::size_t points)
        : shape_(shape), points_(points), values_(points * shape.size(), 1000.0) {}

    SyntheticRecord& noise(double deviation, double alpha, std::uint64_t seed) {
        for (std::size_t at = 0; at < shape_.size(); at += 2) {
            const auto pair = coloured(points_, alpha, seed * 4096 + at);
            for (std::size_t which = 0; which < 2 && at + which < shape_.size(); ++which) {
                for (std::size_t t = 0; t < points_; ++t)
                    values_[t * shape_.size() + at + which] += deviation * pair[which][t];
            }
        }
        return *this;
    }

    /// a cos(2 pi k (x - v t)/L + phase), x in the middle of bins; each sample has its own phase,
    /// which walks at random with `diffusion` (radian^2 per interval).
    SyntheticRecord& wave(double amplitude, double velocity, int k = 1, double diffusion = 0,
                          std::uint64_t seed = 1) {
        const double q = 2 * std::numbers::pi * k / static_cast<double>(shape_.bins);
        for (std::size_t s = 0; s < shape_.samples; ++s) {
            double phase = static_cast<double>(s);
            for (std::size_t t = 0; t < points_; ++t) {
                const auto step = normal_pair(seed, RandomStream::signal, s * points_ + t)[0];
                phase += std::sqrt(diffusion) * step;
                for (std::size_t i = 0; i < shape_.bins; ++i) {
                    const double x = static_cast<double>(i) + 0.5;
                    values_[t * shape_.size() + i * shape_.samples + s] +=
                        amplitude * std::cos(q * (x - velocity * static_cast<double>(t)) + phase);
                }
            }
        }
        return *this;
    }

    /// k = 1 in one sample.
    SyntheticRecord& wave_in(std::size_t sample, double amplitude, double velocity) {
        const double q = 2 * std::numbers::pi / static_cast<double>(shape_.bins);
        for (std::size_t t = 0; t < points_; ++t) {
            for (std::size_t i = 0; i < shape_.bins; ++i) {
                const double x = static_cast<double>(i) - velocity * static_cast<double>(t);
                values_[t * shape_.size() + i * shape_.samples + sample] +=
                    amplitude * std::cos(q * x);
            }
        }
        return *this;
    }

    [[nodiscard]] measure::BinnedRecord description() const {
        return {.shape = shape_, .length = static_cast<double>(shape_.bins), .interval = 1};
    }
    [[nodiscard]] std::size_t points() const { return points_; }
    [[nodiscard]] std::vector<std::uint16_t> field(std::size_t t) const {
        std::vector<std::uint16_t> counts;
        for (std::size_t at = 0; at < shape_.size(); ++at)
            counts.push_back(static_cast<std::uint16_t>(
                std::lround(std::max(0.0, values_[t * shape_.size() + at]))));
        return counts;
    }
    /// All of it as one segment.
    [[nodiscard]] measure::RecordSegments segment() const {
        measure::RecordSegments segment({0, shape_.bins - 1}, shape_.samples, points_);
        for (std::size_t t = 0; t < points_; ++t)
            segment.add(field(t));
        return segment;
    }

  private:
    measure::FieldShape shape_;
    std::size_t points_;
    std::vector<double> values_;  ///< shape (points, bins, samples)
};

}  // namespace crossgrain::tests
