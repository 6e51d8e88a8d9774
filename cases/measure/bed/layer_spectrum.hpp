// |sum_X f_X exp(-2 pi i X K/L)|^2 of a real row f of length L, by FFTW.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace crossgrain::measure {

/// Unnormalised periodogram of one row of cells (Taguchi, chao-dyn/9405003 (1994), Eq. 5). One
/// object per thread; making and destroying objects is safe in any thread.
class LayerSpectrum {
  public:
    /// `cells` = L > 0.
    explicit LayerSpectrum(std::size_t cells);
    ~LayerSpectrum();
    LayerSpectrum(LayerSpectrum&&) noexcept;
    LayerSpectrum& operator=(LayerSpectrum&&) noexcept;

    [[nodiscard]] std::size_t cells() const noexcept;
    /// Shape (L/2 + 1), K = 0, 1, ...; `row` has shape (L).
    [[nodiscard]] std::vector<double> operator()(std::span<const double> row);

  private:
    struct Plan;
    std::unique_ptr<Plan> plan_;
};

}  // namespace crossgrain::measure
