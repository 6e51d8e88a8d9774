#include "cases/measure/gas/gas_overlap.hpp"

#include "cases/measure/gas/gas_window.hpp"
#include "native/base/memory_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

std::vector<std::int64_t> lags_in_frames(const scene::GasSampling& sampling,
                                         const GasOverlapOptions& options) {
    std::vector<std::int64_t> lags;
    if (!(options.lag_min > 0 && options.lag_step > 0)) return lags;
    constexpr double most = 1e6;
    if ((options.lag_max - options.lag_min) / options.lag_step > most) {
        throw std::invalid_argument(fmt::format("lags {} to {} by {} steps are more than {:g}",
                                                options.lag_min, options.lag_max, options.lag_step,
                                                most));
    }
    for (double lag = options.lag_min; lag <= options.lag_max; lag += options.lag_step) {
        const auto frames = std::llround(lag / static_cast<double>(sampling.every));
        if (frames > 0 && (lags.empty() || frames > lags.back())) lags.push_back(frames);
    }
    return lags;
}

void check(const scene::GasSampling& sampling, const GasOverlapOptions& options,
           const std::vector<std::int64_t>& lags) {
    const auto require = [](bool holds, const std::string& what) {
        if (!holds) throw std::invalid_argument(what);
    };
    require(sampling.periodic, "the overlap needs a periodic pipe");
    require(sampling.fields.count, "the overlap needs the field 'count'");
    require(lags.size() >= 3,
            fmt::format("lags {} to {} by {} steps give {} different frames, three or more needed",
                        options.lag_min, options.lag_max, options.lag_step, lags.size()));
    require(options.smoothing > 0 && 2 * options.smoothing < sampling.length,
            fmt::format("smoothing must be > 0 and less than half the pipe of {} sites, not {}",
                        sampling.length, options.smoothing));
    require(
        options.v_min >= 0 && options.v_max > options.v_min,
        fmt::format("speeds need 0 <= v_min < v_max, not {} and {}", options.v_min, options.v_max));
    require(options.references >= 1, "references must be at least 1");
    require(lags.back() < sampling.frames(),
            fmt::format("the largest lag of {} steps needs a longer run than {} steps",
                        options.lag_max, sampling.steps));
}

}  // namespace

GasOverlap::GasOverlap(const scene::GasSampling& sampling, GasOverlapOptions options)
    : sampling_(sampling), options_(options), shape_{static_cast<std::size_t>(sampling.bins()),
                                                     static_cast<std::size_t>(sampling.replicas)},
      lags_(lags_in_frames(sampling, options)), rows_(0), stride_(0) {
    check(sampling, options, lags_);
    rows_ = static_cast<std::size_t>(std::max(1.0, std::round(options.smoothing / sampling.bin)));
    const std::int64_t spaced = sampling.frames() / options.references;
    stride_ = std::max(lags_.back() + 1, spaced);
    require_memory(8.0 * static_cast<double>(lags_.size() + 1) * static_cast<double>(shape_.size()),
                   "overlaps at all lags");
    overlaps_.assign((lags_.size() + 1) * shape_.size(), 0.0F);
    pending_ = overlaps_;
}

void GasOverlap::add(const scene::GasFrame& frame) {
    const std::int64_t since = frame_++ % stride_;
    const auto lag = std::ranges::find(lags_, since);
    if (since != 0 && lag == lags_.end()) return;
    const std::vector<float> field = fluctuation(shape_, frame.count, rows_);
    if (since == 0) {
        reference_ = field;
        std::ranges::fill(pending_, 0.0F);
    }
    const auto at = since == 0 ? 0 : static_cast<std::size_t>(lag - lags_.begin()) + 1;
    add_overlap(shape_, reference_, field,
                std::span(pending_).subspan(at * shape_.size(), shape_.size()));
    if (since != lags_.back()) return;
    ++completed_;
    for (std::size_t i = 0; i < overlaps_.size(); ++i)
        overlaps_[i] += pending_[i];
}

// In sites, each the one nearest to where the line from the origin through the last one points.
std::vector<double> GasOverlap::shifts(std::size_t replica) const {
    std::vector<double> shifts;
    const auto length = static_cast<double>(sampling_.length);
    for (std::size_t k = 0; k < lags_.size(); ++k) {
        const auto overlap = std::span(overlaps_).subspan((k + 1) * shape_.size(), shape_.size());
        double shift = best_shift(shape_, overlap, replica, rows_).refined * sampling_.bin;
        if (k > 0) {
            const double expected =
                shifts.back() * static_cast<double>(lags_[k]) / static_cast<double>(lags_[k - 1]);
            shift += length * std::round((expected - shift) / length);
        }
        shifts.push_back(shift);
    }
    return shifts;
}

ShiftLine GasOverlap::line_through(const std::vector<double>& shifts) const {
    std::vector<double> times;
    for (const std::int64_t lag : lags_)
        times.push_back(static_cast<double>(lag * sampling_.every));
    return shift_line(times, shifts, options_.smoothing);
}

double GasOverlap::height(std::size_t lag) const {
    double heights = 0, self = 0;
    const auto overlap = std::span(overlaps_).subspan((lag + 1) * shape_.size(), shape_.size());
    for (std::size_t r = 0; r < shape_.replicas; ++r) {
        heights += best_shift(shape_, overlap, r).overlap;
        self += double{overlaps_[r]};  // of the reference with itself, unmoved
    }
    return self > 0 ? heights / self : 0.0;
}

void GasOverlap::finish(Results& results) {
    if (completed_ == 0) return;
    std::vector<std::vector<double>> all, waves;
    std::vector<double> velocities;
    std::size_t others = 0;
    for (std::size_t r = 0; r < shape_.replicas; ++r) {
        all.push_back(shifts(r));
        const ShiftLine line = line_through(all.back());
        const double speed = std::abs(line.slope);
        if (!line.travels) continue;
        if (speed < options_.v_min || speed > options_.v_max) {
            ++others;
            continue;
        }
        waves.push_back(all.back());
        velocities.push_back(line.slope);
    }
    const auto& shown = waves.empty() ? all : waves;
    Series series{.name = "overlap",
                  .columns = {"T", "shift", "err", "height"},
                  .values = std::vector<std::vector<double>>(4),
                  .units = {"steps", "sites", "sites", "1"}};
    for (std::size_t k = 0; k < lags_.size(); ++k) {
        std::vector<double> at_lag;
        for (const auto& one : shown)
            at_lag.push_back(one[k]);
        const numerics::MeanWithError mean = numerics::mean_with_error(at_lag);
        series.values[0].push_back(static_cast<double>(lags_[k] * sampling_.every));
        series.values[1].push_back(mean.value);
        series.values[2].push_back(mean.standard_error);
        series.values[3].push_back(height(k));
    }
    results.series.push_back(std::move(series));
    const Measurement share = fraction("overlap_wave_fraction", waves.size(), all.size());
    results.measurements.push_back(share);
    results.measurements.push_back(fraction("overlap_other_fraction", others, all.size()));
    if (velocities.size() < 2) return;
    Measurement velocity = over_replicas("overlap_velocity", velocities, "sites/step");
    velocity.settings = {{"lag_min", static_cast<double>(lags_.front() * sampling_.every)},
                         {"lag_max", static_cast<double>(lags_.back() * sampling_.every)},
                         {"smoothing", options_.smoothing},
                         {"references", static_cast<double>(completed_)},
                         {"share", share.value}};
    results.measurements.push_back(velocity);
}

}  // namespace crossgrain::measure
