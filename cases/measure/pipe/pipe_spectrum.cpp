#include "cases/measure/pipe/pipe_spectrum.hpp"

#include "cases/measure/statistics/pair_transform.hpp"
#include "cases/measure/statistics/parzen_window.hpp"
#include "native/numerics/jackknife.hpp"
#include "native/numerics/mean_with_error.hpp"
#include "native/numerics/median.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {

PipeSpectrum::PipeSpectrum(const scene::Scene& scene, PipeSpectrumOptions options)
    : recorder_(scene, options.record), options_(options) {
    if (options.segments < 2) throw std::invalid_argument("needs segments >= 2");
    if (!(options.low > 0 && options.high > 0 && options.high <= 0.5)) {
        throw std::invalid_argument("needs low > 0 (of the wave's frequency) and 0 < high <= 0.5 "
                                    "(of V/b)");
    }
}

/// P in counts^2 per (cycle per frame), mean over the bins: its integral over f is the variance.
std::vector<double> PipeSpectrum::segment_power(std::size_t first) const {
    const PipeRecord& record = recorder_.record();
    const auto window = parzen_window(points_);
    PairTransform transform(points_);
    std::vector<double> power(points_ / 2 + 1, 0.0), nobody(power.size());
    const auto input = transform.input();
    for (std::size_t i = 0; i < record.bins; i += 2) {
        const bool two = i + 1 < record.bins;
        std::complex<double> mean;
        const auto counts = [&](std::size_t t) {
            const auto* at = &record.count[(first + t) * record.bins + i];
            return std::complex<double>(at[0], two ? at[1] : 0.0);
        };
        for (std::size_t t = 0; t < points_; ++t)
            mean += counts(t) / static_cast<double>(points_);
        for (std::size_t t = 0; t < points_; ++t)
            input[t] = window[t] * std::complex<float>(counts(t) - mean);
        transform.forward();
        transform.add_power(power, two ? power : nobody);
    }
    double squares = 0;
    for (const float w : window)
        squares += static_cast<double>(w) * static_cast<double>(w);
    for (double& p : power)
        p *= 2 / (squares * static_cast<double>(record.bins));
    return power;
}

/// Mean over the segments; `left_out` = their number leaves none out.
std::vector<double> PipeSpectrum::mean_without(std::size_t left_out) const {
    std::vector<double> mean(points_ / 2 + 1, 0.0);
    const double n = static_cast<double>(power_.size() - (left_out < power_.size() ? 1 : 0));
    for (std::size_t s = 0; s < power_.size(); ++s) {
        if (s == left_out) continue;
        for (std::size_t k = 0; k < mean.size(); ++k)
            mean[k] += power_[s][k] / n;
    }
    return mean;
}

/// Cycles per frame.
std::optional<double> PipeSpectrum::peak(const std::vector<double>& power, double highest) const {
    constexpr double least_ratio = 3;
    constexpr std::size_t lowest = 3;
    const auto points = static_cast<double>(points_);
    const auto last = std::min(power.size() - 2, static_cast<std::size_t>(highest * points));
    const auto smooth = [&](std::size_t k) {
        return (power[k - 1] + 2 * power[k] + power[k + 1]) / 4;
    };
    std::size_t top = lowest;
    for (std::size_t k = lowest; k <= last; ++k) {
        if (smooth(k) > smooth(top)) top = k;
    }
    std::vector<double> around;
    for (std::size_t k = std::max<std::size_t>(1, top / 2); k <= std::min(2 * top, last); ++k)
        around.push_back(power[k]);
    if (around.empty() || smooth(top) < least_ratio * numerics::median(around)) {
        return std::nullopt;
    }
    return static_cast<double>(top) / points;
}

void PipeSpectrum::append_alpha(const std::vector<double>& power, Results& results) const {
    constexpr double least_decades = 0.5;
    const PipeRecord& record = recorder_.record();
    const double speed = std::abs(record.mean_speed()), per_frame = record.interval;
    const double top = options_.high * speed / record.bin * per_frame;
    const auto wave = peak(power, top);
    const double f_wave = wave ? *wave : speed / record.length * per_frame;
    const FrequencyWindow window{options_.low * f_wave, top};
    const double decades = std::log10(window.high / window.low);
    if (!(decades >= least_decades)) return;
    const auto slope = log_binned_slope(power, points_, window);
    if (!slope) return;
    double least = *slope, most = *slope;
    const std::array<FrequencyWindow, 3> others{{{1.5 * window.low, window.high},
                                                 {window.low, window.high / 2},
                                                 {1.5 * window.low, window.high / 2}}};
    for (const FrequencyWindow& other : others) {
        const auto value = log_binned_slope(power, points_, other);
        if (!value) continue;
        least = std::min(least, *value);
        most = std::max(most, *value);
    }
    std::vector<double> without;
    for (std::size_t s = 0; s < power_.size(); ++s) {
        if (const auto own = log_binned_slope(mean_without(s), points_, window)) {
            without.push_back(*own);
        }
    }
    if (without.size() < power_.size()) return;
    results.measurements.push_back({.observable = "alpha",
                                    .value = -*slope,
                                    .standard_error = numerics::jackknife_error(without),
                                    .systematic = (most - least) / 2,
                                    .n = power_.size(),
                                    .settings = {{"f_min", window.low / per_frame},
                                                 {"f_max", window.high / per_frame},
                                                 {"decades", decades},
                                                 {"peak", wave ? *wave / per_frame : 0.0},
                                                 {"bin", record.bin}}});
}

void PipeSpectrum::append_series(const std::vector<double>& power, Results& results) const {
    constexpr std::size_t single = 512, together = 8;
    const double interval = recorder_.record().interval;
    Series series{.name = "spectrum",
                  .columns = {"f", "P", "err"},
                  .values = {{}, {}, {}},
                  .units = {"1/t", "grains^2 t", "grains^2 t"}};
    std::vector<double> own(power_.size());
    for (std::size_t k = 1; k < power.size();) {
        const std::size_t count = std::min(k <= single ? 1 : together, power.size() - k);
        for (std::size_t s = 0; s < power_.size(); ++s) {
            const auto part = std::span(power_[s]).subspan(k, count);
            own[s] = numerics::mean_with_error(part).value * interval;
        }
        const numerics::MeanWithError p = numerics::mean_with_error(own);
        const double middle = static_cast<double>(k) + static_cast<double>(count - 1) / 2;
        series.values[0].push_back(middle / static_cast<double>(points_) / interval);
        series.values[1].push_back(p.value);
        series.values[2].push_back(p.standard_error);
        k += count;
    }
    results.series.push_back(std::move(series));
}

void PipeSpectrum::finish(Results& results) {
    const PipeRecord& record = recorder_.record();
    const auto segments = static_cast<std::size_t>(options_.segments);
    points_ = record.frames() / segments / 2 * 2;
    if (points_ < fewest_pipe_frames) return;
    if (const auto refusal = too_coarse_sampling(record)) {
        results.findings.push_back(*refusal);
        return;
    }
    for (std::size_t s = 0; s < segments; ++s)
        power_.push_back(segment_power(s * points_));
    const std::vector<double> power = mean_without(segments);
    append_alpha(power, results);
    append_series(power, results);
}

}  // namespace crossgrain::measure
