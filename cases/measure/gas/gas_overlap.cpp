#include "cases/measure/gas/gas_overlap.hpp"

#include "cases/measure/gas/gas_record.hpp"
#include "cases/measure/waves/over_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

void require(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument(what);
}

std::vector<std::size_t> lags_in_frames(const scene::GasSampling& sampling,
                                        const GasOverlapOptions& o) {
    constexpr double most = 1e6;
    require(o.lag_min > 0 && o.lag_step > 0 && (o.lag_max - o.lag_min) / o.lag_step <= most,
            fmt::format("needs lag_min > 0, lag_step > 0 and at most {:g} lags, not {} to {} by {} "
                        "steps",
                        most, o.lag_min, o.lag_max, o.lag_step));
    std::vector<std::size_t> lags;
    for (double lag = o.lag_min; lag <= o.lag_max; lag += o.lag_step) {
        const auto frames =
            static_cast<std::size_t>(std::llround(lag / static_cast<double>(sampling.every)));
        if (frames > 0 && (lags.empty() || frames > lags.back())) lags.push_back(frames);
    }
    require(!lags.empty() && lags.back() < static_cast<std::size_t>(sampling.frames()),
            fmt::format("the largest lag of {} steps needs a longer run than {} steps", o.lag_max,
                        sampling.steps));
    return lags;
}

OverlapVelocity overlap_of(const scene::GasSampling& sampling, const GasOverlapOptions& o,
                           std::vector<std::size_t> lags) {
    require(sampling.periodic, "the overlap needs a periodic pipe");
    require(sampling.fields.count, "the overlap needs the field 'count'");
    require(o.v_min >= 0 && o.v_max > o.v_min,
            fmt::format("speeds need 0 <= v_min < v_max, not {} and {}", o.v_min, o.v_max));
    require(o.references >= 1, "references must be at least 1");
    return {gas_record(sampling),
            {.lags = std::move(lags),
             .smoothing = o.smoothing,
             .band = {o.v_min, o.v_max},
             .expected = std::nullopt}};
}

}  // namespace

GasOverlap::GasOverlap(const scene::GasSampling& sampling, GasOverlapOptions options)
    : replicas_(static_cast<std::size_t>(sampling.replicas)), frames_(sampling.frames()),
      lags_(lags_in_frames(sampling, options)), overlap_(overlap_of(sampling, options, lags_)) {
    stride_ = std::max(static_cast<std::int64_t>(lags_.back()) + 1, frames_ / options.references);
}

void GasOverlap::add(const scene::GasFrame& frame) {
    const std::int64_t at = frame_++, since = at % stride_;
    const auto lag = std::ranges::find(lags_, static_cast<std::size_t>(since));
    const auto longest = static_cast<std::int64_t>(lags_.back());
    if (at - since + longest >= frames_) return;  // a reference that cannot be followed to the end
    if (since != 0 && lag == lags_.end()) return;
    const std::vector<float> field = overlap_.smoothed(frame.count);
    if (since == 0) reference_ = field;
    overlap_.add(since == 0 ? 0 : static_cast<std::size_t>(lag - lags_.begin()) + 1, reference_,
                 field);
    completed_ += since == longest ? 1 : 0;
}

void GasOverlap::finish(Results& results) {
    if (completed_ == 0) return;
    const std::size_t others = overlap_.append_share(results);
    results.measurements.push_back(fraction("overlap_other_fraction", others, replicas_));
    overlap_.append_velocity(results);
}

}  // namespace crossgrain::measure
