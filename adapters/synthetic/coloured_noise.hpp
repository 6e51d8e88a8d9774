// Gaussian noise with the power spectrum 1/f^alpha, by spectral synthesis: independent complex
// normal Fourier coefficients of variance proportional to f^-alpha (Timmer & Koenig 1995, Astron.
// Astrophys. 300, 707), so that the spectrum is exact at every frequency and nothing is aliased.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace crossgrain::adapters {

class ColouredNoise {
  public:
    /// Series of `length` >= 1 points, cut from a period of at least twice that, so that what is
    /// measured on them is not periodic. `exponent` is alpha >= 0, `deviation` the standard
    /// deviation over the period.
    ColouredNoise(std::size_t length, double exponent, double deviation);
    ~ColouredNoise();
    ColouredNoise(const ColouredNoise&) = delete;
    ColouredNoise& operator=(const ColouredNoise&) = delete;

    /// The series of that number, a pure function of (seed, number) and what was said above.
    /// Shape (length); valid until the next call. Numbers below 2^32.
    [[nodiscard]] std::span<const double> series(std::uint64_t seed, std::uint64_t number);

  private:
    struct Plan;
    std::size_t length_;
    std::vector<double> amplitudes_;  ///< of the real and imaginary parts, by frequency
    std::unique_ptr<Plan> plan_;
};

}  // namespace crossgrain::adapters
