// Long waves of density and flux along a pipe,
//
//   n_k(t) = sum_i n_i exp(-2 pi i k (i + 1/2)/K),   J_k(t) the same of the flux,
//
// and the regression of flux on density,
//
//   dJ/drho = sum_k (Re <J_k n_k*> - N V) / sum_k (<|n_k|^2> - N),   wavelengths L/k >=
//   wavelength_min,
//
// leaves out what a grain contributes with itself: N and N V, which would give the mean velocity V
// whatever the wave.
#pragma once

#include "cases/measure/pipe/pipe_record.hpp"
#include "cases/measure/waves/mode_spectrum.hpp"

#include <complex>
#include <vector>

namespace crossgrain::measure {

/// Shapes (frames).
struct PipeMode {
    std::vector<std::complex<double>> density, flux;
};

/// `k` from 0 (all grains) to bins/2.
[[nodiscard]] PipeMode pipe_mode(const PipeRecord& record, std::size_t k);

/// Their spectra over the whole run, one sample, for speeds up to 4 V.
[[nodiscard]] ModeSpectrum mode_spectrum(const PipeRecord& record);

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
