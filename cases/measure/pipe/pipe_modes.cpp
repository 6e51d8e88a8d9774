#include "cases/measure/pipe/pipe_modes.hpp"

#include "cases/measure/statistics/pair_transform.hpp"
#include "cases/measure/statistics/parzen_window.hpp"
#include "native/numerics/median.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace crossgrain::measure {
namespace {

/// Power at signed frequencies: index j stands for j - points/2 cycles per `points` frames.
std::vector<double> signed_power(std::span<const std::complex<double>> mode) {
    const std::size_t points = mode.size() / 2 * 2, half = points / 2;
    PairTransform transform(points);
    const auto window = parzen_window(points);
    const auto input = transform.input();
    for (std::size_t t = 0; t < points; ++t)
        input[t] = window[t] * std::complex<float>(mode[t]);
    transform.forward();
    std::vector<double> power(points + 1);
    for (std::size_t k = 0; k <= half; ++k) {
        // Of real and imaginary part; i times the latter makes the whole again.
        const auto [real, imaginary] = transform.at(k);
        const std::complex<float> i(0.0F, 1.0F);
        power[half + k] = static_cast<double>(std::norm(real + i * imaginary));
        power[half - k] =
            static_cast<double>(std::norm(std::conj(real) + i * std::conj(imaginary)));
    }
    return power;
}

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

std::optional<TurningFrequency> turning_frequency(std::span<const std::complex<double>> mode) {
    constexpr double least_ratio = 20;
    if (mode.size() < 64) return std::nullopt;
    const std::vector<double> power = signed_power(mode);
    const std::size_t half = power.size() / 2;
    std::size_t top = half;
    double highest = 0;
    for (std::size_t j = 1; j + 1 < power.size(); ++j) {
        const double smooth = (power[j - 1] + 2 * power[j] + power[j + 1]) / 4;
        if (smooth <= highest) continue;
        highest = smooth;
        top = j;
    }
    const double background = numerics::median(power);
    if (!(highest > least_ratio * background)) return std::nullopt;
    const std::size_t away = top > half ? top - half : half - top;
    const std::size_t reach = std::max<std::size_t>(4, away / 4);
    double sum = 0, moment = 0;
    for (std::size_t j = top - std::min(top, reach); j <= top + reach && j < power.size(); ++j) {
        const double excess = std::max(0.0, power[j] - background);
        sum += excess;
        moment += excess * (static_cast<double>(j) - static_cast<double>(half));
    }
    return TurningFrequency{.frequency = moment / sum / static_cast<double>(2 * half),
                            .ratio = background > 0 ? highest / background : 0.0};
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
