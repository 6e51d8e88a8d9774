#include "cases/measure/gas/gas_spectrum.hpp"

#include "cases/measure/gas/gas_window.hpp"
#include "cases/measure/statistics/parzen_window.hpp"
#include "native/base/memory_budget.hpp"
#include "native/numerics/jackknife.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

void require(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument(what);
}

/// Fills in the defaults that depend on the pipe, and refuses what makes no sense.
GasSpectrumOptions checked(const scene::GasSampling& sampling, GasSpectrumOptions o) {
    require(sampling.fields.count, "the frames have no field \"count\"");
    require(o.segments >= 1 && o.points >= 64 && o.points % 2 == 0,
            "needs segments >= 1 and an even number of points >= 64");
    require(o.segments * o.points <= sampling.frames(),
            fmt::format("the series of {} frames is shorter than {} segments of {} points",
                        sampling.frames(), o.segments, o.points));
    require(o.f_min > 0 && 2 * o.f_min < o.f_max && o.f_max <= 0.5,
            "needs 0 < 2 f_min < f_max <= 0.5 (cycles per record)");
    require(o.v_min > 0 && o.v_max > o.v_min, "needs 0 < v_min < v_max");
    require(o.running_mean >= 0 && o.running_mean < o.points,
            "running_mean must be from 0 to the number of points");
    if (o.last_bin < 0) o.last_bin = sampling.bins() - 1;
    require(o.first_bin >= 0 && o.first_bin <= o.last_bin && o.last_bin < sampling.bins(),
            fmt::format("needs 0 <= first_bin <= last_bin < {} bins", sampling.bins()));
    require_memory(4.0 * static_cast<double>(o.last_bin - o.first_bin + 2) * sampling.replicas *
                       static_cast<double>(o.points),
                   "segments of all bins and replicas");
    return o;
}

BinRange bins_of(const GasSpectrumOptions& o) {
    return {static_cast<std::size_t>(o.first_bin), static_cast<std::size_t>(o.last_bin)};
}

}  // namespace

GasSpectrum::GasSpectrum(const scene::GasSampling& sampling, GasSpectrumOptions options)
    : sampling_(sampling), options_(checked(sampling, options)),
      replicas_(static_cast<std::size_t>(sampling.replicas)),
      points_(static_cast<std::size_t>(options_.points)),
      segments_(bins_of(options_), replicas_, points_), transform_(points_),
      window_(parzen_window(points_)), power_(replicas_ * (points_ / 2 + 1), 0.0) {
    double squares = 0;
    for (const float w : window_)
        squares += static_cast<double>(w) * static_cast<double>(w);
    normalisation_ = 2 / (squares * static_cast<double>(bins_of(options_).size()) *
                          static_cast<double>(options_.segments));
}

void GasSpectrum::add(const scene::GasFrame& frame) {
    if (done_ == options_.segments || !segments_.add(frame.count)) return;
    transform_segment();
    ++done_;
}

void GasSpectrum::transform_segment() {
    const std::size_t size = points_ / 2 + 1;
    const auto running_mean = static_cast<std::size_t>(options_.running_mean);
    std::vector<double> nobody(size);  // where the second half of an odd last pair goes
    const auto input = transform_.input();
    for (std::size_t pair = 0; pair < segments_.pairs(); ++pair) {
        segments_.pair(pair, running_mean, input);
        for (std::size_t j = 0; j < points_; ++j)
            input[j] *= window_[j];
        transform_.forward();
        const auto row = [&](std::size_t series) {
            if (series >= segments_.series()) return std::span(nobody);
            return std::span(power_).subspan(series % replicas_ * size, size);
        };
        transform_.add_power(row(2 * pair), row(2 * pair + 1));
    }
}

/// P of the mean over the replicas first..last.
std::vector<double> GasSpectrum::spectrum(std::size_t first, std::size_t last) const {
    const std::size_t size = points_ / 2 + 1;
    std::vector<double> mean(size, 0.0);
    for (std::size_t r = first; r <= last; ++r) {
        for (std::size_t k = 0; k < size; ++k)
            mean[k] += power_[r * size + k];
    }
    for (double& value : mean)
        value *= normalisation_ / static_cast<double>(last - first + 1);
    return mean;
}

double GasSpectrum::velocity(double k) const {
    return k / static_cast<double>(points_) * sampling_.length /
           static_cast<double>(sampling_.every);
}

PeakSearch GasSpectrum::peak_search() const {
    const double k_per_velocity = 1 / velocity(1);
    return {.first = static_cast<std::size_t>(std::ceil(options_.v_min * k_per_velocity)),
            .last = static_cast<std::size_t>(std::floor(options_.v_max * k_per_velocity))};
}

double GasSpectrum::velocity_error(const std::vector<double>& mean) const {
    const std::size_t groups = std::min<std::size_t>(16, replicas_);
    if (groups < 2) return 0;
    const auto n = static_cast<double>(replicas_);
    std::vector<double> velocities;
    for (std::size_t g = 0; g < groups; ++g) {
        const std::size_t first = g * replicas_ / groups, next = (g + 1) * replicas_ / groups;
        const auto own = spectrum(first, next - 1);
        const auto share = static_cast<double>(next - first);
        std::vector<double> without(mean.size());
        for (std::size_t k = 0; k < mean.size(); ++k)
            without[k] = (n * mean[k] - share * own[k]) / (n - share);
        const auto peak = find_peak(without, peak_search());
        if (peak) velocities.push_back(velocity(peak->k));
    }
    return velocities.size() < 2 ? 0 : numerics::jackknife_error(velocities);
}

std::optional<SpectrumPeak> GasSpectrum::add_wave(const std::vector<double>& mean,
                                                  Results& results) const {
    if (!sampling_.periodic) return std::nullopt;
    const auto positive = [](double p) { return p > 0; };
    if (!std::ranges::all_of(mean, positive)) return std::nullopt;
    const auto peak = find_peak(mean, peak_search());
    if (!peak) return std::nullopt;
    std::size_t waves = 0;
    for (std::size_t r = 0; r < replicas_; ++r) {
        const auto own = spectrum(r, r);
        if (!std::ranges::all_of(own, positive)) continue;
        if (const auto found = find_peak(own, peak_search())) waves += found->significant ? 1 : 0;
    }
    results.measurements.push_back(fraction("wave_fraction", waves, replicas_));
    if (!peak->significant) return peak;
    results.measurements.push_back({.observable = "wave_velocity",
                                    .value = velocity(peak->k),
                                    .standard_error = velocity_error(mean),
                                    .systematic = velocity(0.5),
                                    .n = replicas_,
                                    .unit = "sites/step",
                                    .settings = {{"peak_ratio", peak->ratio},
                                                 {"peak_sigmas", peak->sigmas},
                                                 {"v_min", options_.v_min},
                                                 {"v_max", options_.v_max}}});
    return peak;
}

double GasSpectrum::alpha_error(const std::vector<double>& mean, FrequencyWindow window) const {
    if (replicas_ < 2) return 0;
    const auto n = static_cast<double>(replicas_);
    const auto size = std::min(
        mean.size(), static_cast<std::size_t>(window.high * static_cast<double>(points_)) + 2);
    std::vector<double> without(size), slopes;
    for (std::size_t r = 0; r < replicas_; ++r) {
        const double* own = &power_[r * mean.size()];
        for (std::size_t k = 0; k < size; ++k) {
            without[k] = (n * mean[k] - normalisation_ * own[k]) / (n - 1);
        }
        const auto slope = log_binned_slope(without, points_, window);
        if (slope) slopes.push_back(*slope);
    }
    return slopes.size() < 2 ? 0 : numerics::jackknife_error(slopes);
}

void GasSpectrum::add_alpha(const std::vector<double>& mean, double f_max, Results& results) const {
    const double f_min = options_.f_min;
    const FrequencyWindow window{f_min, f_max};
    const auto slope = log_binned_slope(mean, points_, window);
    if (!slope) return;
    double least = *slope, most = *slope;
    const std::array<FrequencyWindow, 4> others{
        {{f_min / 2, f_max}, {2 * f_min, f_max}, {f_min / 2, f_max / 2}, {f_min, f_max / 2}}};
    for (const FrequencyWindow& other : others) {
        const auto value = log_binned_slope(mean, points_, other);
        if (!value) continue;
        least = std::min(least, *value);
        most = std::max(most, *value);
    }
    results.measurements.push_back(
        {.observable = "alpha",
         .value = -*slope,
         .standard_error = alpha_error(mean, window),
         .systematic = (most - least) / 2,
         .n = replicas_,
         .settings = {{"f_min", f_min},
                      {"f_max", f_max},
                      {"segments", static_cast<double>(options_.segments)},
                      {"points", static_cast<double>(options_.points)},
                      {"running_mean", static_cast<double>(options_.running_mean)}}});
}

void GasSpectrum::add_series(const std::vector<double>& mean, Results& results) const {
    constexpr std::size_t single = 1024, together = 8;
    Series series{.name = "spectrum",
                  .columns = {"f", "P", "err"},
                  .values = {{}, {}, {}},
                  .units = {"1/record", "particles^2 records", "particles^2 records"}};
    std::vector<double> by_replica(replicas_);
    for (std::size_t k = 1; k < mean.size();) {
        const std::size_t count = std::min(k <= single ? 1 : together, mean.size() - k);
        for (std::size_t r = 0; r < replicas_; ++r) {
            double sum = 0;
            for (std::size_t j = k; j < k + count; ++j)
                sum += power_[r * mean.size() + j];
            by_replica[r] = normalisation_ * sum / static_cast<double>(count);
        }
        const numerics::MeanWithError power = numerics::mean_with_error(by_replica);
        const double middle = static_cast<double>(k) + static_cast<double>(count - 1) / 2;
        series.values[0].push_back(middle / static_cast<double>(points_));
        series.values[1].push_back(power.value);
        series.values[2].push_back(power.standard_error);
        k += count;
    }
    results.series.push_back(std::move(series));
}

void GasSpectrum::finish(Results& results) {
    if (done_ < options_.segments) return;
    const std::vector<double> mean = spectrum(0, replicas_ - 1);
    const auto peak = add_wave(mean, results);
    double f_max = options_.f_max;
    if (peak && peak->significant) {
        f_max = std::min(f_max, 0.7 * peak->k / static_cast<double>(points_));
    }
    add_alpha(mean, f_max, results);
    add_series(mean, results);
}

}  // namespace crossgrain::measure
