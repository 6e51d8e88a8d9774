#include "cases/measure/discharge/discharge_rate.hpp"

#include "native/numerics/line_fit.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

constexpr std::size_t parts_of_window = 10;

}  // namespace

DischargeRate::DischargeRate(const scene::Scene& scene, DischargeRateOptions options)
    : walls_(hopper_walls(scene)), options_(options) {
    check_ranges(options);
    if (options.to && !(*options.to > options.from)) {
        throw std::invalid_argument(
            fmt::format("needs from < to, not {} and {}", options.from, *options.to));
    }
    std::vector<double> heights;
    for (const std::size_t i : walls_.mobile) {
        masses_.push_back(scene.grains.mass_of(i));
        heights.push_back(scene.initial.y[i] - walls_.level);
    }
    total_ = std::accumulate(masses_.begin(), masses_.end(), 0.0);
    const auto top = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() * 98 / 100);
    std::ranges::nth_element(heights, top);
    initial_area_ = walls_.area_below(std::max(*top, walls_.diameter));
}

void DischargeRate::add(const scene::Frame& frame) {
    double out = 0;
    for (std::size_t m = 0; m < walls_.mobile.size(); ++m) {
        if (frame.y[walls_.mobile[m]] < walls_.level) out += masses_[m];
    }
    times_.push_back(frame.time);
    discharged_.push_back(out);
}

double DischargeRate::filling_height(double discharged) const {
    return walls_.height_of(initial_area_ * (1 - discharged / total_));
}

std::vector<DischargeRate::Stretch> DischargeRate::stretches(std::size_t first, std::size_t last,
                                                             std::size_t count) const {
    std::vector<Stretch> parts;
    for (std::size_t s = 0; s < count; ++s) {
        const std::size_t a = first + (last - first) * s / count;
        const std::size_t b = first + (last - first) * (s + 1) / count;
        const double discharged = (discharged_[a] + discharged_[b]) / 2;
        parts.push_back({.time = (times_[a] + times_[b]) / 2,
                         .discharged = discharged,
                         .rate = (discharged_[b] - discharged_[a]) / (times_[b] - times_[a]),
                         .height = filling_height(discharged)});
    }
    return parts;
}

void DischargeRate::append_state(const std::vector<Stretch>& parts, double halves, double error,
                                 Results& results) const {
    const auto still = std::ranges::count_if(parts, [](const Stretch& s) { return s.rate == 0; });
    const bool jammed = 5 * static_cast<std::size_t>(still) >= parts.size();
    const bool steady = std::abs(halves) < std::max(0.03, 3 * error);
    results.findings.push_back(
        {.name = "flow",
         .label = jammed ? "jammed" : (steady ? "steady" : "changing"),
         .detail =
             jammed
                 ? fmt::format("nothing came out in {} of {} stretches", still, parts.size())
                 : fmt::format("second half over first half: {:+.3f} +- {:.3f}", halves, error)});
}

void DischargeRate::append_rate(std::size_t first, std::size_t last, Results& results) const {
    const std::vector<Stretch> parts = stretches(first, last, parts_of_window);
    std::vector<double> times, rates, log_heights, log_rates;
    for (const Stretch& part : parts) {
        times.push_back(part.time);
        rates.push_back(part.rate);
        if (!(part.rate > 0 && part.height > 0)) continue;
        log_rates.push_back(std::log(part.rate));
        log_heights.push_back(std::log(part.height));
    }
    const double duration = times_[last] - times_[first];
    const double rate = (discharged_[last] - discharged_[first]) / duration;
    const auto append = [&](const char* name, double value, double error, const char* unit = "1") {
        results.measurements.push_back(
            {.observable = name,
             .value = value,
             .standard_error = error,
             .n = parts.size(),
             .unit = unit,
             .settings = {{"from", times_[first]},
                          {"to", times_[last]},
                          {"outlet", walls_.outlet},
                          {"half_angle", std::atan(walls_.tangent) * 180 / std::numbers::pi}}});
    };
    append("flow_rate", rate, numerics::mean_with_error(rates).standard_error, "m/t");
    const numerics::LineFit drift = numerics::fit_line(times, rates);
    append("flow_rate_drift", drift.slope * duration / rate, drift.slope_error() * duration / rate);
    const numerics::MeanWithError early =
        numerics::mean_with_error(std::span(rates).first(parts.size() / 2));
    const numerics::MeanWithError late =
        numerics::mean_with_error(std::span(rates).last(parts.size() / 2));
    const double halves = late.value / early.value - 1;
    const double error = std::hypot(early.standard_error, late.standard_error) / rate;
    if (early.value > 0) append("flow_rate_halves", halves, error);
    const bool changes = parts.back().height < 0.9 * parts.front().height;
    if (changes && log_rates.size() == parts.size()) {
        const numerics::LineFit exponent = numerics::fit_line(log_heights, log_rates);
        append("flow_exponent", exponent.slope, exponent.slope_error());
    }
    append_state(parts, halves, error, results);
}

void DischargeRate::append_series(Results& results) const {
    constexpr std::size_t rows = 50;
    Series series{.name = "discharge",
                  .columns = {"t", "discharged", "rate", "height"},
                  .values = std::vector<std::vector<double>>(4),
                  .units = {"t", "m", "m/t", "l"}};
    const auto parts = stretches(0, times_.size() - 1, std::min(rows, times_.size() - 1));
    for (const Stretch& part : parts) {
        series.values[0].push_back(part.time);
        series.values[1].push_back(part.discharged);
        series.values[2].push_back(part.rate);
        series.values[3].push_back(part.height);
    }
    results.series.push_back(std::move(series));
}

void DischargeRate::finish(Results& results) {
    constexpr std::size_t fewest_frames = 2 * parts_of_window;
    std::size_t first = times_.size(), last = 0;
    for (std::size_t i = 0; i < times_.size(); ++i) {
        if (times_[i] < options_.from || times_[i] > options_.to.value_or(times_[i])) continue;
        if (discharged_[i] > (1 - options_.down_to) * total_) break;
        first = std::min(first, i);
        last = i;
    }
    if (first >= last || last - first < fewest_frames) return;
    append_series(results);
    if (discharged_[last] > discharged_[first]) append_rate(first, last, results);
}

}  // namespace crossgrain::measure
