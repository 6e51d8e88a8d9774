#include "cases/measure/bed/velocity_spectrum.hpp"

#include "cases/measure/bed/plate_motion.hpp"
#include "cases/measure/statistics/power_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace crossgrain::measure {
namespace {

constexpr std::array<int, 3> stated_windows{8, 16, 32};

void check(const VelocitySpectrumOptions& options) {
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw std::invalid_argument(fmt::format("velocity spectrum: {}", what));
    };
    check_ranges(options);
    require(options.k_max > options.k_min, "needs k_min < k_max");
    require(options.from.has_value() == options.to.has_value(), "a window needs 'from' and 'to'");
    require(!options.from || *options.from < *options.to, "the window must end after it begins");
}

}  // namespace

VelocitySpectrum::VelocitySpectrum(const scene::Scene& scene, VelocitySpectrumOptions options)
    : options_(std::move(options)), rows_(lattice_rows(scene)), mass_(scene.grains.mass),
      interval_(scene.dt * static_cast<double>(scene.frame_every)),
      period_(driving_period(scene.plates)), window_{.label = "window"}, slope_columns_(5) {
    check(options_);
    if (!rows_) return;
    spectrum_.emplace(rows_->columns);
    for (const double time : options_.times)
        times_.push_back({.label = fmt::format("t{:g}", time)});
    for (const double phase : options_.phases)
        phases_.push_back({.label = fmt::format("phase{:g}", phase)});
}

VelocitySpectrum::Instant VelocitySpectrum::measure(const scene::Frame& frame) {
    Instant instant{.time = options_.clock + frame.time};
    const std::size_t columns = rows_->columns;
    for (std::size_t j = 0; j < rows_->rows; ++j) {
        instant.row_spectra.push_back((*spectrum_)(frame.vx.subspan(j * columns, columns)));
    }
    instant.mean = mean_spectrum(instant.row_spectra);
    const double sum = std::inner_product(frame.vx.begin(), frame.vx.end(), frame.vx.begin(), 0.0);
    instant.transverse_energy = mass_ / 2 * sum / static_cast<double>(frame.vx.size());
    return instant;
}

bool VelocitySpectrum::is_at(double time, const Instant& instant) const {
    // Half open, so that one of two frames equally far away is taken; round-off is forgiven.
    const double early = time - instant.time;
    return early > -interval_ * (0.5 - 1e-9) && early <= interval_ * (0.5 + 1e-9);
}

void VelocitySpectrum::read_times(const Instant& instant) {
    for (std::size_t i = 0; i < times_.size(); ++i) {
        Reading& reading = times_[i];
        if (reading.frames > 0 || !is_at(options_.times[i], instant)) continue;
        reading.samples = instant.row_spectra;
        reading.time_sum = instant.time;
        reading.energy_sum = instant.transverse_energy;
        reading.frames = 1;
    }
}

void VelocitySpectrum::read_phases(const Instant& instant) {
    if (!period_ || instant.time < options_.skip - interval_ / 2) return;
    for (std::size_t i = 0; i < phases_.size(); ++i) {
        const double offset = options_.phases[i] / 360 * *period_;
        const double passage = std::round((instant.time - offset) / *period_) * *period_ + offset;
        if (passage < options_.skip - 1e-9 * interval_ || !is_at(passage, instant)) continue;
        phases_[i].samples.push_back(instant.mean);
        phases_[i].time_sum += instant.time;
        phases_[i].energy_sum += instant.transverse_energy;
        ++phases_[i].frames;
    }
}

void VelocitySpectrum::read_window(const Instant& instant) {
    if (!options_.from || instant.time < *options_.from || instant.time > *options_.to) return;
    const double sum = std::accumulate(instant.mean.begin() + 1, instant.mean.end(), 0.0);
    if (!(sum > 0)) return;
    const double since = instant.time - *options_.from;
    const auto sample = static_cast<std::size_t>(period_ ? since / *period_ : 0.0);
    if (window_.samples.size() <= sample) {
        window_.samples.resize(sample + 1, std::vector<double>(instant.mean.size(), 0.0));
    }
    auto& total = window_.samples[sample];
    std::ranges::transform(total, instant.mean, total.begin(),
                           [sum](double so_far, double power) { return so_far + power / sum; });
    window_.time_sum += instant.time;
    window_.energy_sum += instant.transverse_energy;
    ++window_.frames;
}

void VelocitySpectrum::follow_slope(const Instant& instant) {
    std::array<double, 5> row{instant.time, 0, 0, 0, instant.transverse_energy};
    for (std::size_t w = 0; w < stated_windows.size(); ++w) {
        const auto slope = log_log_slope(instant.mean, 1, stated_windows[w]);
        if (!slope) return;
        row[w + 1] = *slope;
    }
    for (std::size_t c = 0; c < row.size(); ++c)
        slope_columns_[c].push_back(row[c]);
}

void VelocitySpectrum::add(const scene::Frame& frame) {
    if (!rows_) return;
    const Instant instant = measure(frame);
    read_times(instant);
    read_phases(instant);
    read_window(instant);
    follow_slope(instant);
}

void VelocitySpectrum::add_measurements(const Reading& reading, Results& results) const {
    if (reading.frames == 0) return;
    const auto frames = static_cast<double>(reading.frames);
    const double time = reading.time_sum / frames;
    results.measurements.push_back({.observable = "transverse_energy_" + reading.label,
                                    .value = reading.energy_sum / frames,
                                    .n = reading.frames,
                                    .unit = "m l^2/t^2",
                                    .settings = {{"t", time}}});
    const std::vector<double> mean = mean_spectrum(reading.samples);
    const auto slope_over = [&](int k_min, int k_max) -> std::optional<Measurement> {
        const auto value = log_log_slope(mean, k_min, k_max);
        if (!value) return std::nullopt;
        const auto with_error = slope_of_mean(reading.samples, k_min, k_max);
        return Measurement{.value = *value,
                           .standard_error = with_error ? with_error->standard_error : 0.0,
                           .n = reading.samples.size(),
                           .settings = {{"k_min", k_min}, {"k_max", k_max}, {"t", time}}};
    };
    const std::string name = "velocity_slope_" + reading.label;
    auto slope = slope_over(options_.k_min, options_.k_max);
    if (!slope) return;
    double least = slope->value, most = slope->value;
    for (const int k_max : stated_windows) {
        auto other = slope_over(1, k_max);
        if (!other) continue;
        least = std::min(least, other->value);
        most = std::max(most, other->value);
        other->observable = fmt::format("{}_K1_{}", name, k_max);
        results.measurements.push_back(std::move(*other));
    }
    slope->observable = name;
    slope->systematic = (most - least) / 2;
    results.measurements.push_back(std::move(*slope));
}

void VelocitySpectrum::add_extremes(Results& results) const {
    std::vector<Measurement> slopes;
    for (std::size_t i = 0; i < phases_.size(); ++i) {
        const auto found = std::ranges::find(
            results.measurements, "velocity_slope_" + phases_[i].label, &Measurement::observable);
        if (found == results.measurements.end()) continue;
        slopes.push_back(*found);
        slopes.back().settings["phase"] = options_.phases[i];
    }
    if (slopes.size() < 2) return;
    const auto [steepest, flattest] = std::ranges::minmax(slopes, {}, &Measurement::value);
    results.measurements.push_back(steepest);
    results.measurements.back().observable = "velocity_slope_steepest";
    results.measurements.push_back(flattest);
    results.measurements.back().observable = "velocity_slope_flattest";
}

void VelocitySpectrum::add_series(Results& results) const {
    const std::size_t highest = rows_->columns / 2;
    Series spectra{.name = "velocity-spectrum", .columns = {"K"}, .values = {{}}};
    for (std::size_t k = 1; k <= highest; ++k)
        spectra.values[0].push_back(static_cast<double>(k));
    const auto add_column = [&](const Reading& reading) {
        if (reading.frames == 0) return;
        const std::vector<double> mean = mean_spectrum(reading.samples);
        spectra.columns.push_back("E_" + reading.label);
        spectra.values.emplace_back(mean.begin() + 1, mean.end());
    };
    std::ranges::for_each(times_, add_column);
    std::ranges::for_each(phases_, add_column);
    add_column(window_);
    if (spectra.columns.size() > 1) results.series.push_back(std::move(spectra));
    if (slope_columns_.front().empty()) return;
    results.series.push_back(
        {.name = "velocity-slope",
         .columns = {"t", "slope_K1_8", "slope_K1_16", "slope_K1_32", "transverse_energy"},
         .values = slope_columns_,
         .units = {"t", "1", "1", "1", "m l^2/t^2"}});
}

void VelocitySpectrum::finish(Results& results) {
    if (!rows_) return;
    // A window of less than a period leaves its last sample without a frame.
    std::erase_if(window_.samples, [](const auto& sample) { return !(sample[1] > 0); });
    for (const Reading& reading : times_)
        add_measurements(reading, results);
    for (const Reading& reading : phases_)
        add_measurements(reading, results);
    add_extremes(results);
    add_measurements(window_, results);
    add_series(results);
}

}  // namespace crossgrain::measure
