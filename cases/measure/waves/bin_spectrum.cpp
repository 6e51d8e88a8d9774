#include "cases/measure/waves/bin_spectrum.hpp"

#include "cases/measure/statistics/parzen_window.hpp"
#include "native/numerics/jackknife.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace crossgrain::measure {

BinSpectrum::BinSpectrum(BinRange bins, std::size_t samples, std::size_t points,
                         std::size_t running_mean)
    : bins_(bins), samples_(samples), points_(points), running_mean_(running_mean),
      transform_(points), window_(parzen_window(points)), power_(samples * (points / 2 + 1), 0.0) {}

void BinSpectrum::add(RecordSegments& segment) {
    const std::size_t size = points_ / 2 + 1;
    double squares = 0;
    for (const float w : window_)
        squares += double{w} * double{w};
    const double scale = 2 / (squares * static_cast<double>(bins_.size()));
    std::vector<double> first(size), second(size);
    const auto input = transform_.input();
    for (std::size_t pair = 0; pair < segment.pairs(); ++pair) {
        segment.pair(pair, running_mean_, input);
        for (std::size_t j = 0; j < points_; ++j)
            input[j] *= window_[j];
        transform_.forward();
        std::ranges::fill(first, 0.0);
        std::ranges::fill(second, 0.0);
        transform_.add_power(first, second);
        const auto keep = [&](std::size_t series, const std::vector<double>& power) {
            if (series >= segment.series()) return;
            double* own = &power_[series % samples_ * size];
            for (std::size_t k = 0; k < size; ++k)
                own[k] += scale * power[k];
        };
        keep(2 * pair, first);
        keep(2 * pair + 1, second);
    }
    ++segments_;
}

std::vector<double> BinSpectrum::mean() const {
    const std::size_t size = points_ / 2 + 1;
    std::vector<double> mean(size, 0.0);
    for (std::size_t at = 0; at < power_.size(); ++at)
        mean[at % size] += power_[at] / static_cast<double>(segments_ * samples_);
    return mean;
}

/// Error of the slope by the jackknife over the samples; 0 for one.
double BinSpectrum::slope_error(const std::vector<double>& mean, FrequencyWindow window) const {
    const double n = static_cast<double>(samples_), segments = static_cast<double>(segments_);
    std::vector<double> without(mean.size()), slopes;
    for (std::size_t s = 0; samples_ > 1 && s < samples_; ++s) {
        const double* own = &power_[s * mean.size()];
        for (std::size_t k = 0; k < mean.size(); ++k)
            without[k] = (n * mean[k] - own[k] / segments) / (n - 1);
        if (const auto slope = log_binned_slope(without, points_, window)) slopes.push_back(*slope);
    }
    return slopes.size() < 2 ? 0 : numerics::jackknife_error(slopes);
}

void BinSpectrum::append_alpha(FrequencyWindow window, std::map<std::string, double> settings,
                               Results& results) const {
    const std::vector<double> power = mean();
    const auto slope = log_binned_slope(power, points_, window);
    if (!slope) return;
    double least = *slope, most = *slope;
    const std::array<FrequencyWindow, 3> others{{{2 * window.low, window.high},
                                                 {window.low, window.high / 2},
                                                 {2 * window.low, window.high / 2}}};
    for (const FrequencyWindow& other : others) {
        const auto value = log_binned_slope(power, points_, other);
        if (!value) continue;
        least = std::min(least, *value);
        most = std::max(most, *value);
    }
    results.measurements.push_back({.observable = "alpha",
                                    .value = -*slope,
                                    .standard_error = slope_error(power, window),
                                    .systematic = (most - least) / 2,
                                    .n = samples_,
                                    .settings = std::move(settings)});
}

void BinSpectrum::append_series(const SpectrumScale& scale, Results& results) const {
    constexpr std::size_t single = 1024, together = 8;
    const std::size_t size = points_ / 2 + 1;
    Series series{.name = "spectrum",
                  .columns = {"f", "P", "err"},
                  .values = {{}, {}, {}},
                  .units = {scale.frequency_unit, scale.power_unit, scale.power_unit}};
    std::vector<double> own(samples_);
    for (std::size_t k = 1; k < size;) {
        const std::size_t count = std::min(k <= single ? 1 : together, size - k);
        for (std::size_t s = 0; s < samples_; ++s) {
            const auto part = std::span(power_).subspan(s * size + k, count);
            own[s] = numerics::mean_with_error(part).value * scale.interval /
                     static_cast<double>(segments_);
        }
        const numerics::MeanWithError p = numerics::mean_with_error(own);
        const double middle = static_cast<double>(k) + static_cast<double>(count - 1) / 2;
        series.values[0].push_back(middle / static_cast<double>(points_) / scale.interval);
        series.values[1].push_back(p.value);
        series.values[2].push_back(p.standard_error);
        k += count;
    }
    results.series.push_back(std::move(series));
}

}  // namespace crossgrain::measure
