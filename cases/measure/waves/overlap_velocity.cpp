#include "cases/measure/waves/overlap_velocity.hpp"

#include "cases/measure/waves/field_shift.hpp"
#include "cases/measure/waves/over_samples.hpp"
#include "native/base/memory_budget.hpp"
#include "native/numerics/jackknife.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace crossgrain::measure {
namespace {

/// Whole bins further than `reach` from the expected shift are out of the question.
void keep_within(std::vector<float>& overlap, double expected, double reach) {
    const auto bins = static_cast<double>(overlap.size());
    const float least = std::ranges::min(overlap);
    for (std::size_t s = 0; s < overlap.size(); ++s) {
        const double away = static_cast<double>(s) - expected;
        if (std::abs(away - bins * std::round(away / bins)) > reach) overlap[s] = least;
    }
}

}  // namespace

OverlapVelocity::OverlapVelocity(BinnedRecord record, OverlapOptions options)
    : record_(std::move(record)), options_(std::move(options)), rows_(0) {
    if (options_.lags.size() < 3) {
        throw std::invalid_argument(fmt::format(
            "the intervals give {} different frames, three or more needed", options_.lags.size()));
    }
    if (!(options_.smoothing > 0 && 2 * options_.smoothing < record_.length)) {
        throw std::invalid_argument(
            fmt::format("smoothing must be > 0 and less than half the pipe of {:g} {}, not {:g}",
                        record_.length, record_.length_unit, options_.smoothing));
    }
    rows_ = static_cast<std::size_t>(std::max(1.0, std::round(options_.smoothing / record_.bin())));
    for (const std::size_t lag : options_.lags)
        times_.push_back(static_cast<double>(lag) * record_.interval);
    const std::size_t size = (options_.lags.size() + 1) * record_.shape.size();
    require_memory(sizeof(float) * static_cast<double>(size), "overlaps at all lags");
    sums_.assign(size, 0.0F);
}

std::vector<float> OverlapVelocity::smoothed(std::span<const std::uint16_t> counts) const {
    return fluctuation(record_.shape, counts, rows_);
}

void OverlapVelocity::add(std::size_t lag, std::span<const float> reference,
                          std::span<const float> later) {
    const std::size_t size = record_.shape.size();
    add_overlap(record_.shape, reference, later, std::span(sums_).subspan(lag * size, size));
}

std::size_t OverlapVelocity::groups() const {
    return std::min<std::size_t>(16, record_.shape.samples);
}

OverlapVelocity::Weights OverlapVelocity::without(std::size_t group) const {
    const std::size_t samples = record_.shape.samples;
    Weights weights(samples, 1.0);
    for (std::size_t s = group * samples / groups(); s < (group + 1) * samples / groups(); ++s)
        weights[s] = 0;
    return weights;
}

/// Shape (bins); lag 0 is the overlap of the references with themselves.
std::vector<float> OverlapVelocity::overlap(std::size_t lag, const Weights& weights) const {
    const auto [bins, samples] = record_.shape;
    std::vector<float> sum(bins);
    for (std::size_t i = 0; i < bins; ++i) {
        const float* own = &sums_[(lag * bins + i) * samples];
        double weighted = 0;
        for (std::size_t s = 0; s < samples; ++s)
            weighted += weights[s] * double{own[s]};
        sum[i] = static_cast<float>(weighted);
    }
    return sum;
}

std::vector<double> OverlapVelocity::shifts(const Weights& weights) const {
    const double bin = record_.bin(), length = record_.length;
    const FieldShape one{record_.shape.bins, 1};
    std::vector<double> shifts;
    double expected = options_.expected ? options_.expected->speed * times_.front() : 0;
    for (std::size_t k = 0; k < times_.size(); ++k) {
        if (k > 0) expected = shifts.back() * times_[k] / times_[k - 1];
        std::vector<float> here = overlap(k + 1, weights);
        if (options_.expected) keep_within(here, expected / bin, options_.expected->reach / bin);
        const double shift = best_shift(one, here, 0, rows_).refined * bin;
        shifts.push_back(shift + length * std::round((expected - shift) / length));
    }
    return shifts;
}

ShiftLine OverlapVelocity::line_of(const Weights& weights) const {
    return shift_line(times_, shifts(weights), options_.smoothing);
}

ShiftLine OverlapVelocity::line() const {
    return line_of(Weights(record_.shape.samples, 1.0));
}

ShiftLine OverlapVelocity::line_without(std::size_t group) const {
    return line_of(without(group));
}

bool OverlapVelocity::in_band(const ShiftLine& line) const {
    const double speed = std::abs(line.slope);
    return line.travels && speed >= options_.band.least && speed <= options_.band.most;
}

Series OverlapVelocity::series() const {
    const Weights all(record_.shape.samples, 1.0);
    const std::string& unit = record_.length_unit;
    std::vector<std::vector<double>> others;
    for (std::size_t g = 0; groups() > 1 && g < groups(); ++g)
        others.push_back(shifts(without(g)));
    const double self = double{overlap(0, all).front()};
    Series series{.name = "overlap",
                  .columns = {"T", "shift", "err", "height"},
                  .values = {times_, shifts(all), {}, {}},
                  .units = {record_.time_unit, unit, unit, "1"}};
    for (std::size_t k = 0; k < times_.size(); ++k) {
        std::vector<double> at_lag;
        for (const auto& one : others)
            at_lag.push_back(one[k]);
        series.values[2].push_back(at_lag.empty() ? 0.0 : numerics::jackknife_error(at_lag));
        const double height = double{std::ranges::max(overlap(k + 1, all))};
        series.values[3].push_back(self > 0 ? height / self : 0.0);
    }
    return series;
}

std::size_t OverlapVelocity::append_share(Results& results) const {
    const std::size_t samples = record_.shape.samples;
    std::size_t waves = 0, others = 0;
    for (std::size_t s = 0; s < samples; ++s) {
        Weights own(samples, 0.0);
        own[s] = 1;
        const ShiftLine line = line_of(own);
        waves += in_band(line) ? 1 : 0;
        others += line.travels && !in_band(line) ? 1 : 0;
    }
    results.series.push_back(series());
    results.measurements.push_back(fraction("overlap_wave_fraction", waves, samples));
    return others;
}

bool OverlapVelocity::append_velocity(Results& results) const {
    const ShiftLine all = line();
    if (!in_band(all) || record_.shape.samples < 2) return false;
    std::vector<double> rest;
    for (std::size_t g = 0; g < groups(); ++g)
        rest.push_back(line_without(g).slope);
    results.measurements.push_back({.observable = "overlap_velocity",
                                    .value = all.slope,
                                    .standard_error = numerics::jackknife_error(rest),
                                    .n = record_.shape.samples,
                                    .unit = record_.velocity_unit,
                                    .settings = {{"lag_min", times_.front()},
                                                 {"lag_max", times_.back()},
                                                 {"smoothing", options_.smoothing}}});
    return true;
}

}  // namespace crossgrain::measure
