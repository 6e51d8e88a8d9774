// Long waves of density and flux along a pipe,
//
//   n_k(t) = sum_i n_i exp(-2 pi i k (i + 1/2)/K),   J_k(t) the same of the flux,
//
// the frequency at which n_k turns, and the regression of flux on density.
//
// A wave that moves down at v turns n_k at the frequency -k v/L. The regression of flux on density,
//
//   dJ/drho = sum_k (Re <J_k n_k*> - N V) / sum_k (<|n_k|^2> - N),   wavelengths L/k >=
//   wavelength_min,
//
// leaves out what a grain contributes with itself: N and N V, which would give the mean velocity V
// whatever the wave.
#pragma once

#include "cases/measure/pipe/pipe_record.hpp"

#include <complex>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::measure {

/// Shapes (frames).
struct PipeMode {
    std::vector<std::complex<double>> density, flux;
};

/// `k` from 0 (all grains) to bins/2.
[[nodiscard]] PipeMode pipe_mode(const PipeRecord& record, std::size_t k);

struct TurningFrequency {
    double frequency = 0;  ///< signed, cycles per frame
    double ratio = 0;      ///< power at the peak over the median of all frequencies
};

/// Centre of the peak of the power spectrum (Parzen's window, one segment): the maximum of the
/// power averaged with weights 1, 2, 1, then the centroid of the power over +- 1/4 of its frequency
/// (four frequency steps at least). Nothing if it is not 20 times the median (white noise: 1 in 400
/// for 2500 frames) or for fewer than 64 frames.
[[nodiscard]] std::optional<TurningFrequency>
turning_frequency(std::span<const std::complex<double>> mode);

/// Sums of a regression over some frames, grains with themselves left out; they add.
struct FluxRegression {
    double flux_density = 0;     ///< sum of Re J_k n_k* - N V
    double density_density = 0;  ///< sum of |n_k|^2 - N
    double self = 0;             ///< sum of N
    [[nodiscard]] double slope() const { return flux_density / density_density; }
};

/// By block of the record. `wavelength_min` (l) must leave at least one mode.
[[nodiscard]] std::vector<FluxRegression> flux_regression(const PipeRecord& record,
                                                          double wavelength_min);

/// J(rho) of the fields without wavelengths below `wavelength_min` (l), as area fraction and its
/// flux, of a pipe with mean area fraction `phi`. Columns phi, J (l/t), err (over the blocks),
/// share (of all bins), in classes of phi/10; classes that only one block visits are left out.
[[nodiscard]] Series flux_curve(const PipeRecord& record, double phi, double wavelength_min);

}  // namespace crossgrain::measure
