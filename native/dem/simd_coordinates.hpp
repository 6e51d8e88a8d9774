// What positions mean in the two formats of simd_format.hpp.
#pragma once

#include "native/dem/simd_format.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace crossgrain::dem {

template <class Format>
class Coordinates;

/// Lengths as they are; x within [0, period) when the list is made.
template <>
class Coordinates<DoubleFormat> {
  public:
    explicit Coordinates(const Parameters&) {}
    void fit(double, double) {}
    [[nodiscard]] double unit_x() const { return 1; }
    [[nodiscard]] double unit_y() const { return 1; }
    [[nodiscard]] double x(double value) const { return value; }
    [[nodiscard]] double y(double value) const { return value; }
    [[nodiscard]] double plate(double value) const { return value; }
    /// Where a grain is that was at `start`, which is `listed`, when the list was made.
    [[nodiscard]] double x_now(double, double, double now) const { return now; }
    [[nodiscard]] double y_now(double, double, double now) const { return now; }
    /// Far from all grains, and its square far enough from overflow, of floats as well.
    [[nodiscard]] double dummy_y() const { return 1e18; }
    /// How far all grains may move together before the list has to be made anew.
    [[nodiscard]] double longest_drift() const { return std::numeric_limits<double>::max(); }
};

/// Integers modulo 2^32. The modulus of x divides the period. That of y is at least eight times the
/// height of the grains, so that plates and the dummy are never mistaken for what is half a modulus
/// away: grains stay within 1/8 of the modulus from the middle, plates are kept within 1/4.
template <>
class Coordinates<MixedFormat> {
  public:
    explicit Coordinates(const Parameters& p) : least_modulus_(64 * p.diameter) {
        modulus_x_ = p.period_x
                         ? *p.period_x / std::max(1.0, std::floor(*p.period_x / least_modulus_))
                         : least_modulus_;
    }

    /// To be called with the lowest and the highest grain before the grains are given anew.
    void fit(double low, double high) {
        const bool fits = std::abs(low - middle_y_) <= modulus_y_ / 16 &&
                          std::abs(high - middle_y_) <= modulus_y_ / 16;
        if (fits) return;
        middle_y_ = (low + high) / 2;
        modulus_y_ = std::max(least_modulus_, 12 * (high - low));
    }
    [[nodiscard]] double unit_x() const { return modulus_x_ / two_to_32; }
    [[nodiscard]] double unit_y() const { return modulus_y_ / two_to_32; }
    [[nodiscard]] std::int32_t x(double value) const { return wrap(value / unit_x()); }
    [[nodiscard]] std::int32_t y(double value) const {
        return wrap((value - middle_y_) / unit_y());
    }
    [[nodiscard]] std::int32_t plate(double value) const {
        const double offset = std::clamp(value - middle_y_, -modulus_y_ / 4, modulus_y_ / 4);
        return wrap(offset / unit_y());
    }
    [[nodiscard]] double x_now(double start, std::int32_t listed, std::int32_t now) const {
        return start + unit_x() * difference(now, listed);
    }
    [[nodiscard]] double y_now(double start, std::int32_t listed, std::int32_t now) const {
        return start + unit_y() * difference(now, listed);
    }
    [[nodiscard]] std::int32_t dummy_y() const { return std::numeric_limits<std::int32_t>::min(); }
    [[nodiscard]] double longest_drift() const { return std::min(modulus_x_, modulus_y_) / 16; }

  private:
    static constexpr double two_to_32 = 4294967296.0;

    static std::int32_t wrap(double units) {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(std::llrint(units)));
    }
    static double difference(std::int32_t a, std::int32_t b) {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) -
                                         static_cast<std::uint32_t>(b));
    }

    double least_modulus_;
    double modulus_x_ = 0;
    double modulus_y_ = 0, middle_y_ = 0;
};

}  // namespace crossgrain::dem
