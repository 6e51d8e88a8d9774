#include "cases/measure/gas/gas_correlation.hpp"

#include "native/base/memory_budget.hpp"
#include "native/numerics/jackknife.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

constexpr double least_sigmas = 6;

void require(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument(what);
}

GasCorrelationOptions checked(const scene::GasSampling& sampling, GasCorrelationOptions o) {
    require(sampling.fields.count, "the frames have no field \"count\"");
    require(sampling.replicas >= 16, "needs at least 16 replicas");
    require(o.separation >= 1 && o.separation < sampling.bins(),
            fmt::format("needs a separation from 1 to {} bins", sampling.bins() - 1));
    require(o.v_min > 0 && o.v_max > o.v_min, "needs 0 < v_min < v_max");
    require(o.references >= 1, "needs at least one reference");
    require(o.running_mean >= 0, "needs running_mean >= 0");
    if (o.running_mean > 0) o.running_mean |= 1;
    return o;
}

/// Frames a wave of this velocity needs from one place to the other.
double frames_between(const scene::GasSampling& sampling, const GasCorrelationOptions& o,
                      double velocity) {
    const double frames = static_cast<double>(o.separation * sampling.bin) / velocity /
                          static_cast<double>(sampling.every);
    return std::min(frames, 1e15);  // longer than any run, and still a whole number
}

}  // namespace

GasCorrelation::GasCorrelation(const scene::GasSampling& sampling, GasCorrelationOptions options)
    : sampling_(sampling), options_(checked(sampling, options)),
      bins_(static_cast<std::size_t>(sampling.bins())),
      replicas_(static_cast<std::size_t>(sampling.replicas)),
      separation_(static_cast<std::size_t>(options_.separation)),
      lag_min_(
          static_cast<std::size_t>(std::ceil(frames_between(sampling, options_, options_.v_max)))),
      lag_max_(static_cast<std::size_t>(
          std::floor(frames_between(sampling, options_, options_.v_min)))) {
    require(lag_max_ >= lag_min_ + 8, "fewer than 8 frames between the times of v_max and v_min");
    const auto longest = static_cast<std::int64_t>(lag_max_);
    const std::int64_t usable = sampling.frames() - longest - options_.running_mean;
    require(usable > 0, fmt::format("{} frames are too few for a largest time of {} frames and the "
                                    "running mean",
                                    sampling.frames(), longest));
    require_memory(16.0 * static_cast<double>(lag_max_ + 1) * sampling.replicas,
                   "sums for every time");
    stride_ = std::max<std::int64_t>(1, usable / options_.references);
    active_.resize(static_cast<std::size_t>(longest / stride_ + 1));
    sums_.assign((lag_max_ + 1) * replicas_, 0.0);
    field_.resize(bins_ * replicas_);
    sum_.assign(bins_ * replicas_, 0);
}

void GasCorrelation::add(const scene::GasFrame& frame) {
    if (!frame.saturated.empty()) return;
    const auto size = static_cast<std::size_t>(options_.running_mean);
    if (size == 0) {
        std::ranges::copy(frame.count, field_.begin());
        add_field(frame_++);
        return;
    }
    const auto slot = static_cast<std::size_t>(frame_) % size;
    if (recent_.size() < size) {
        recent_.emplace_back(frame.count.begin(), frame.count.end());
        for (std::size_t j = 0; j < sum_.size(); ++j)
            sum_[j] += frame.count[j];
    } else {
        for (std::size_t j = 0; j < sum_.size(); ++j) {
            sum_[j] += std::uint32_t{frame.count[j]} - recent_[slot][j];
            recent_[slot][j] = frame.count[j];
        }
    }
    ++frame_;
    if (recent_.size() < size) return;
    const auto& centre = recent_[(slot + size - size / 2) % size];
    const float scale = 1.0F / static_cast<float>(size);
    for (std::size_t j = 0; j < sum_.size(); ++j)
        field_[j] = static_cast<float>(centre[j]) - scale * static_cast<float>(sum_[j]);
    add_field(frame_ - options_.running_mean);
}

/// `frame` counts the fields, from 0.
void GasCorrelation::add_field(std::int64_t frame) {
    if (frame % stride_ == 0) {
        Reference& slot = active_[static_cast<std::size_t>(frame / stride_) % active_.size()];
        slot.frame = frame;
        slot.field = field_;
    }
    for (const Reference& reference : active_) {
        if (reference.frame < 0) continue;
        const auto lag = static_cast<std::size_t>(frame - reference.frame);
        if (lag > lag_max_) continue;
        correlate(reference, lag);
        completed_ += lag == lag_max_ ? 1 : 0;
    }
}

void GasCorrelation::correlate(const Reference& reference, std::size_t lag) {
    const std::size_t pairs = sampling_.periodic ? bins_ : bins_ - separation_;
    std::vector<float> products(replicas_, 0.0F);
    for (std::size_t i = 0; i < pairs; ++i) {
        const float* here = &reference.field[i * replicas_];
        const float* there = &field_[(i + separation_) % bins_ * replicas_];
        for (std::size_t r = 0; r < replicas_; ++r)
            products[r] += here[r] * there[r];
    }
    for (std::size_t r = 0; r < replicas_; ++r) {
        sums_[lag * replicas_ + r] += static_cast<double>(products[r]) / static_cast<double>(pairs);
    }
}

/// C of the mean over the replicas first..last, shape (lags). The references not followed to the
/// largest lag when the run ends weigh little; every lag has its own number of them.
std::vector<double> GasCorrelation::curve(std::size_t first, std::size_t last) const {
    std::vector<double> result(lag_max_ + 1);
    const std::int64_t fields =
        options_.running_mean > 0 ? frame_ - options_.running_mean + 1 : frame_;
    for (std::size_t lag = 0; lag <= lag_max_; ++lag) {
        const std::int64_t references = (fields - 1 - static_cast<std::int64_t>(lag)) / stride_ + 1;
        for (std::size_t r = first; r <= last; ++r)
            result[lag] += sums_[lag * replicas_ + r];
        result[lag] /= static_cast<double>(references) * static_cast<double>(last - first + 1);
    }
    return result;
}

/// Of all replicas but first..last.
std::vector<double> GasCorrelation::curve_without(std::size_t first, std::size_t last) const {
    std::vector<double> all = curve(0, replicas_ - 1);
    const std::vector<double> part = curve(first, last);
    const auto n = static_cast<double>(replicas_), left_out = static_cast<double>(last - first + 1);
    for (std::size_t lag = 0; lag < all.size(); ++lag)
        all[lag] = (n * all[lag] - left_out * part[lag]) / (n - left_out);
    return all;
}

std::optional<GasCorrelation::Maximum>
GasCorrelation::maximum(const std::vector<double>& curve) const {
    std::optional<Maximum> best;
    for (std::size_t lag = lag_min_ + 1; lag < lag_max_; ++lag) {
        if (curve[lag] < curve[lag - 1] || curve[lag] < curve[lag + 1]) continue;
        // The lowest ground on either side before something higher comes.
        std::size_t left = lag, right = lag;
        for (std::size_t j = lag; j-- > lag_min_ && curve[j] <= curve[lag];)
            left = curve[j] < curve[left] ? j : left;
        for (std::size_t j = lag + 1; j <= lag_max_ && curve[j] <= curve[lag]; ++j)
            right = curve[j] < curve[right] ? j : right;
        const std::size_t ground = curve[left] > curve[right] ? left : right;
        const double prominence = curve[lag] - curve[ground];
        if (!best || prominence > best->prominence) best = Maximum{lag, ground, prominence};
    }
    return best;
}

/// In frames.
double GasCorrelation::centroid(const std::vector<double>& curve, const Maximum& maximum) {
    const double half = curve[maximum.ground] + maximum.prominence / 2;
    double weight = 0, moment = 0;
    const auto add = [&](std::size_t lag) {
        if (!(curve[lag] > half)) return false;
        weight += curve[lag] - half;
        moment += (curve[lag] - half) * static_cast<double>(lag);
        return true;
    };
    for (std::size_t lag = maximum.lag; lag < curve.size() && add(lag); ++lag) {
    }
    for (std::size_t lag = maximum.lag; lag-- > 0 && add(lag);) {
    }
    return moment / weight;
}

double GasCorrelation::prominence_error(const Maximum& maximum) const {
    std::vector<double> values(replicas_);
    for (std::size_t r = 0; r < replicas_; ++r) {
        const auto own = curve(r, r);
        values[r] = own[maximum.lag] - own[maximum.ground];
    }
    return numerics::mean_with_error(values).standard_error;
}

void GasCorrelation::add_wave(const std::vector<double>& mean, Results& results) const {
    const auto top = maximum(mean);
    if (!top) return;
    const double sigmas = top->prominence / prominence_error(*top);
    if (!(sigmas >= least_sigmas)) return;
    const auto every = static_cast<double>(sampling_.every);
    const auto distance = static_cast<double>(options_.separation * sampling_.bin);
    std::vector<double> times, velocities;
    constexpr std::size_t groups = 16;
    for (std::size_t g = 0; g < groups; ++g) {
        const std::size_t first = g * replicas_ / groups, next = (g + 1) * replicas_ / groups;
        const auto without = curve_without(first, next - 1);
        const auto own = maximum(without);
        if (!own) continue;
        times.push_back(centroid(without, *own) * every);
        velocities.push_back(distance / times.back());
    }
    if (times.size() < 2) return;
    const double time = centroid(mean, *top) * every;
    Measurement measured{
        .observable = "correlation_time",
        .value = time,
        .standard_error = numerics::jackknife_error(times),
        .n = replicas_,
        .unit = "steps",
        .settings = {{"separation", distance},
                     {"sigmas", sigmas},
                     {"running_mean", static_cast<double>(options_.running_mean)}}};
    results.measurements.push_back(measured);
    measured.observable = "correlation_velocity";
    measured.value = distance / time;
    measured.standard_error = numerics::jackknife_error(velocities);
    measured.unit = "sites/step";
    results.measurements.push_back(std::move(measured));
}

void GasCorrelation::finish(Results& results) {
    if (completed_ == 0) return;
    const std::vector<double> mean = curve(0, replicas_ - 1);
    Series series{.name = "correlation",
                  .columns = {"T", "C"},
                  .values = {{}, mean},
                  .units = {"steps", "particles^2"}};
    for (std::size_t lag = 0; lag <= lag_max_; ++lag) {
        series.values[0].push_back(static_cast<double>(lag) * static_cast<double>(sampling_.every));
    }
    results.series.push_back(std::move(series));
    add_wave(mean, results);
}

}  // namespace crossgrain::measure
