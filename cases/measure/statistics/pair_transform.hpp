// Fourier transform of two real series at once, as the real and the imaginary part of a complex one
// (Press et al., Numerical Recipes, section 12.3), in single precision.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace crossgrain::measure {

class PairTransform {
  public:
    /// `points` > 0.
    explicit PairTransform(std::size_t points);
    ~PairTransform();
    PairTransform(const PairTransform&) = delete;
    PairTransform& operator=(const PairTransform&) = delete;
    PairTransform(PairTransform&&) noexcept;

    /// What is transformed, shape (points); kept by forward().
    [[nodiscard]] std::span<std::complex<float>> input() noexcept;
    /// sum_t input_t exp(-2 pi i k t/points), not normalised.
    void forward();
    /// Coefficients of both series at k = 0..points/2.
    [[nodiscard]] std::array<std::complex<float>, 2> at(std::size_t k) const noexcept;
    /// Adds the squared moduli of the coefficients, k = 0..points/2, of the first and the second
    /// series. Shapes (points/2 + 1).
    void add_power(std::span<double> first, std::span<double> second) const noexcept;

  private:
    struct Plan;
    std::unique_ptr<Plan> plan_;
};

}  // namespace crossgrain::measure
