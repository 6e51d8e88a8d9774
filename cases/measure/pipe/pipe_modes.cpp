#include "cases/measure/pipe/pipe_modes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace crossgrain::measure {
namespace {

/// What a class of densities has seen, by block.
struct DensityClass {
    std::array<double, pipe_blocks> cells{}, flux{};
    double density = 0;
};

Series series_of(const std::vector<DensityClass>& classes, double all) {
    Series series{.name = "flux",
                  .columns = {"phi", "J", "err", "share"},
                  .values = std::vector<std::vector<double>>(4),
                  .units = {"1", "l/t", "l/t", "1"}};
    for (const DensityClass& one : classes) {
        double cells = 0, flux = 0, squares = 0;
        for (std::size_t b = 0; b < pipe_blocks; ++b) {
            cells += one.cells[b];
            flux += one.flux[b];
        }
        if (std::ranges::count_if(one.cells, [](double c) { return c > 0; }) < 2) continue;
        const double mean = flux / cells;
        for (std::size_t b = 0; b < pipe_blocks; ++b)
            squares += std::pow(one.flux[b] - mean * one.cells[b], 2);
        const std::array row{one.density / cells, mean, std::sqrt(squares) / cells, cells / all};
        for (std::size_t c = 0; c < row.size(); ++c)
            series.values[c].push_back(row[c]);
    }
    return series;
}

std::size_t modes_from(const PipeRecord& record, double wavelength_min) {
    return static_cast<std::size_t>(record.length / wavelength_min);
}

/// exp(-2 pi i k (i + 1/2)/K)
std::complex<double> phase_at(const PipeRecord& record, std::size_t k, std::size_t i) {
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(record.bins);
    return std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) * x);
}

}  // namespace

PipeMode pipe_mode(const PipeRecord& record, std::size_t k) {
    std::vector<std::complex<double>> phase;
    for (std::size_t i = 0; i < record.bins; ++i)
        phase.push_back(phase_at(record, k, i));
    PipeMode mode;
    for (std::size_t f = 0; f < record.frames(); ++f) {
        const auto count = record.count_at(f);
        const auto flux = record.flux_at(f);
        std::complex<double> density_k, flux_k;
        for (std::size_t i = 0; i < record.bins; ++i) {
            density_k += static_cast<double>(count[i]) * phase[i];
            flux_k += static_cast<double>(flux[i]) * phase[i];
        }
        mode.density.push_back(density_k);
        mode.flux.push_back(flux_k);
    }
    return mode;
}

ModeSpectrum mode_spectrum(const PipeRecord& record) {
    constexpr double fastest = 4;
    const std::size_t points = record.frames() / 2 * 2;
    ModeSpectrum modes(record.in_blocks(1), points, {0, fastest * std::abs(record.mean_speed())});
    RecordSegments segment({0, record.bins - 1}, 1, points);
    for (std::size_t t = 0; t < points; ++t)
        segment.add(record.count_at(t));
    modes.add(segment);
    return modes;
}

std::vector<FluxRegression> flux_regression(const PipeRecord& record, double wavelength_min) {
    const auto blocks = equal_blocks(record.frames(), pipe_blocks);
    std::vector<FluxRegression> sums(blocks.size());
    const PipeMode whole = pipe_mode(record, 0);
    for (std::size_t k = 1; k <= modes_from(record, wavelength_min); ++k) {
        const PipeMode mode = pipe_mode(record, k);
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            for (std::size_t f = blocks[b].first; f < blocks[b].last; ++f) {
                const double grains = whole.density[f].real();
                sums[b].flux_density +=
                    std::real(mode.flux[f] * std::conj(mode.density[f])) - whole.flux[f].real();
                sums[b].density_density += std::norm(mode.density[f]) - grains;
                sums[b].self += grains;
            }
        }
    }
    return sums;
}

Series flux_curve(const PipeRecord& record, double phi, double wavelength_min) {
    constexpr double classes_per_mean = 10;
    const auto bins = static_cast<double>(record.bins);
    std::vector<PipeMode> modes;
    for (std::size_t k = 0; k <= modes_from(record, wavelength_min); ++k)
        modes.push_back(pipe_mode(record, k));
    std::vector<std::complex<double>> back;  // shape (modes, bins)
    for (std::size_t k = 0; k < modes.size(); ++k) {
        for (std::size_t i = 0; i < record.bins; ++i)
            back.push_back(std::conj(phase_at(record, k, i)) * (k == 0 ? 1.0 : 2.0) / bins);
    }
    const double phi_per_grain = phi * bins / modes[0].density[0].real();
    std::vector<DensityClass> classes;
    const auto blocks = equal_blocks(record.frames(), pipe_blocks);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        for (std::size_t f = blocks[b].first; f < blocks[b].last; ++f) {
            for (std::size_t i = 0; i < record.bins; ++i) {
                double n = 0, j = 0;
                for (std::size_t k = 0; k < modes.size(); ++k) {
                    n += std::real(modes[k].density[f] * back[k * record.bins + i]);
                    j += std::real(modes[k].flux[f] * back[k * record.bins + i]);
                }
                const double density = std::max(0.0, n * phi_per_grain);
                const auto at = static_cast<std::size_t>(classes_per_mean * density / phi);
                if (at >= classes.size()) classes.resize(at + 1);
                classes[at].cells[b] += 1;
                classes[at].flux[b] += j * phi_per_grain;
                classes[at].density += density;
            }
        }
    }
    return series_of(classes, static_cast<double>(record.frames()) * bins);
}

}  // namespace crossgrain::measure
