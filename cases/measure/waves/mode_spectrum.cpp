#include "cases/measure/waves/mode_spectrum.hpp"

#include "cases/measure/statistics/parzen_window.hpp"
#include "native/base/memory_budget.hpp"
#include "native/numerics/jackknife.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace crossgrain::measure {

ModeSpectrum::ModeSpectrum(BinnedRecord record, std::size_t points, SpeedBand band)
    : record_(std::move(record)), points_(points), band_(band), window_(parzen_window(points)),
      transform_(points) {
    if (record_.shape.bins <= 2 * modes) {
        throw std::invalid_argument("the velocity of waves needs nine bins or more");
    }
    const std::size_t size = record_.shape.samples * modes * 2 * (points_ / 2 + 1);
    require_memory(sizeof(float) * static_cast<double>(size), "spectra of the longest waves");
    power_.assign(size, 0.0F);
    const auto bins = static_cast<double>(record_.shape.bins);
    for (std::size_t k = 1; k <= modes; ++k) {
        for (std::size_t i = 0; i < record_.shape.bins; ++i) {
            const double x = (static_cast<double>(i) + 0.5) / bins;
            phases_.emplace_back(
                std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) * x));
        }
    }
}

void ModeSpectrum::add(const RecordSegments& segment) {
    const auto [bins, samples] = record_.shape;
    const std::size_t half = points_ / 2;
    const auto input = transform_.input();
    for (std::size_t s = 0; s < samples; ++s) {
        for (std::size_t mode = 0; mode < modes; ++mode) {
            std::ranges::fill(input, 0.0F);
            for (std::size_t i = 0; i < bins; ++i)
                segment.add_to(i * samples + s, phases_[mode * bins + i], input);
            const auto mean = std::reduce(input.begin(), input.end()) / static_cast<float>(points_);
            for (std::size_t t = 0; t < points_; ++t)
                input[t] = window_[t] * (input[t] - mean);
            transform_.forward();
            float* up = &power_[(s * modes + mode) * 2 * (half + 1)];
            float* down = up + half + 1;
            for (std::size_t k = 0; k <= half; ++k) {
                // Of real and imaginary part; i times the latter makes the whole again.
                const auto [real, imaginary] = transform_.at(k);
                const std::complex<float> i(0.0F, 1.0F);
                up[k] += std::norm(real + i * imaginary);
                down[k] += std::norm(std::conj(real) + i * std::conj(imaginary));
            }
        }
    }
    ++segments_;
}

std::vector<double> ModeSpectrum::power(std::size_t mode, std::size_t direction, std::size_t first,
                                        std::size_t last) const {
    const std::size_t size = points_ / 2 + 1;
    std::vector<double> sum(size, 0.0);
    for (std::size_t s = first; s < last; ++s) {
        const float* own = &power_[((s * modes + mode) * 2 + direction) * size];
        for (std::size_t k = 0; k < size; ++k)
            sum[k] += static_cast<double>(own[k]);
    }
    return sum;
}

/// Along gravity, of k cycles per segment in the spectrum of a direction.
double ModeSpectrum::velocity(std::size_t mode, std::size_t direction, double k) const {
    const double speed = k / static_cast<double>(points_) / record_.interval * record_.length /
                         static_cast<double>(mode + 1);
    return direction == 0 ? -speed : speed;
}

PeakSearch ModeSpectrum::search(std::size_t mode, std::size_t samples) const {
    const double step = velocity(mode, 1, 1), last = static_cast<double>(points_ / 2);
    return {.first = std::max<std::size_t>(
                1, static_cast<std::size_t>(std::ceil(std::min(last, band_.least / step)))),
            .last = static_cast<std::size_t>(std::floor(std::min(last, band_.most / step))),
            .degrees = 2 * static_cast<double>(samples * segments_),
            .spectra = 2 * modes};
}

std::optional<WavePeak> ModeSpectrum::strongest(std::size_t first, std::size_t last) const {
    std::optional<WavePeak> best;
    for (std::size_t mode = 0; mode < modes; ++mode) {
        for (const std::size_t direction : {0U, 1U}) {
            const auto peak =
                find_peak(power(mode, direction, first, last), search(mode, last - first));
            if (!peak || !peak->significant) continue;
            if (best && peak->excess <= best->peak.excess) continue;
            best = WavePeak{.k = mode + 1,
                            .velocity = velocity(mode, direction, peak->k),
                            .fundamental = peak->k / static_cast<double>(points_ * (mode + 1)),
                            .peak = *peak};
        }
    }
    return best;
}

std::size_t ModeSpectrum::strongest_mode() const {
    std::array<double, modes> sums{};
    for (std::size_t mode = 0; mode < modes; ++mode) {
        for (const std::size_t direction : {0U, 1U}) {
            for (const double p : power(mode, direction, 0, record_.shape.samples))
                sums[mode] += p;
        }
    }
    return static_cast<std::size_t>(std::ranges::max_element(sums) - sums.begin()) + 1;
}

std::optional<WavePeak> ModeSpectrum::wave() const {
    return strongest(0, record_.shape.samples);
}

std::optional<WavePeak> ModeSpectrum::wave_of(std::size_t sample) const {
    return strongest(sample, sample + 1);
}

double ModeSpectrum::velocity_error(const WavePeak& wave) const {
    const std::size_t samples = record_.shape.samples, mode = wave.k - 1;
    const std::size_t direction = wave.velocity > 0 ? 1 : 0;
    if (samples == 1) return velocity(mode, 1, wave.peak.k_error);
    const std::size_t groups = std::min<std::size_t>(16, samples);
    const std::vector<double> all = power(mode, direction, 0, samples);
    std::vector<double> velocities;
    for (std::size_t g = 0; g < groups; ++g) {
        const std::size_t first = g * samples / groups, next = (g + 1) * samples / groups;
        std::vector<double> rest = power(mode, direction, first, next);
        std::ranges::transform(all, rest, rest.begin(), std::minus{});
        const auto peak = find_peak(rest, search(mode, samples - (next - first)));
        if (peak) velocities.push_back(velocity(mode, direction, peak->k));
    }
    return velocities.size() < 2 ? 0 : numerics::jackknife_error(velocities);
}

std::optional<WavePeak> ModeSpectrum::append_wave(Results& results) const {
    const auto found = wave();
    if (!found) return found;
    results.measurements.push_back({.observable = "wave_velocity",
                                    .value = found->velocity,
                                    .standard_error = velocity_error(*found),
                                    .systematic = velocity(found->k - 1, 1, 0.5),
                                    .n = record_.shape.samples,
                                    .unit = record_.velocity_unit,
                                    .settings = {{"k", static_cast<double>(found->k)},
                                                 {"peak_ratio", found->peak.ratio},
                                                 {"peak_sigmas", found->peak.sigmas()}}});
    return found;
}

}  // namespace crossgrain::measure
