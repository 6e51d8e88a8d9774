#include "cases/measure/waves/overlap_velocity.hpp"

#include "cases/measure/waves/field_shift.hpp"
#include "cases/measure/waves/over_samples.hpp"
#include "native/base/memory_budget.hpp"
#include "native/numerics/jackknife.hpp"

#include <boost/math/distributions/binomial.hpp>
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

OverlapVelocity::Weights OverlapVelocity::only(std::size_t sample) const {
    Weights weights(record_.shape.samples, 0.0);
    weights[sample] = 1;
    return weights;
}

OverlapVelocity::Weights OverlapVelocity::without(Weights weights, std::size_t group) const {
    const std::size_t samples = weights.size();
    for (std::size_t s = group * samples / groups(); s < (group + 1) * samples / groups(); ++s)
        weights[s] = 0;
    return weights;
}

OverlapVelocity::Weights OverlapVelocity::counting() const {
    constexpr double level = 1e-3;
    const std::size_t samples = record_.shape.samples;
    const Weights all(samples, 1.0);
    if (in_band(line_of(all))) return all;
    Weights own(samples, 0.0);
    for (std::size_t s = 0; s < samples; ++s)
        own[s] = in_band(line_of(only(s))) ? 1.0 : 0.0;
    const auto waves = static_cast<double>(std::ranges::count(own, 1.0));
    const double chance = 2 * std::pow(2 * options_.smoothing / record_.length,
                                       static_cast<double>(times_.size()) - 2);
    const boost::math::binomial noise(static_cast<double>(samples), std::min(chance, 1.0));
    if (waves < 2 || boost::math::cdf(boost::math::complement(noise, waves - 1)) > level) {
        return all;
    }
    return own;
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
    return line_of(counting());
}

ShiftLine OverlapVelocity::line_without(std::size_t group) const {
    return line_of(without(counting(), group));
}

bool OverlapVelocity::in_band(const ShiftLine& line) const {
    const double speed = std::abs(line.slope);
    return line.travels && speed >= options_.band.least && speed <= options_.band.most;
}

Series OverlapVelocity::series() const {
    const Weights all = counting();
    const std::string& unit = record_.length_unit;
    std::vector<std::vector<double>> others;
    for (std::size_t g = 0; groups() > 1 && g < groups(); ++g)
        others.push_back(shifts(without(all, g)));
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
        const ShiftLine line = line_of(only(s));
        waves += in_band(line) ? 1 : 0;
        others += line.travels && !in_band(line) ? 1 : 0;
    }
    results.series.push_back(series());
    results.measurements.push_back(fraction("overlap_wave_fraction", waves, samples));
    return others;
}

bool OverlapVelocity::append_velocity(Results& results) const {
    const Weights weights = counting();
    const ShiftLine wave = line_of(weights);
    const auto samples = static_cast<std::size_t>(std::ranges::count(weights, 1.0));
    if (!in_band(wave) || samples < 2) return false;
    std::vector<double> rest;
    for (std::size_t g = 0; g < groups(); ++g)
        rest.push_back(line_of(without(weights, g)).slope);
    const double share = static_cast<double>(samples) / static_cast<double>(record_.shape.samples);
    results.measurements.push_back({.observable = "overlap_velocity",
                                    .value = wave.slope,
                                    .standard_error = numerics::jackknife_error(rest),
                                    .n = samples,
                                    .unit = record_.velocity_unit,
                                    .settings = {{"lag_min", times_.front()},
                                                 {"lag_max", times_.back()},
                                                 {"smoothing", options_.smoothing},
                                                 {"share", share}}});
    return true;
}

}  // namespace crossgrain::measure
