#include "cases/measure/pipe/pipe_overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace crossgrain::measure {
namespace {

constexpr double search_reach = 100;  // diameters

void check(const PipeRecord& record, const PipeOverlapOptions& o) {
    if (!(o.lag_min > 0 && o.lag_step > 0 && o.lag_max > o.lag_min)) {
        throw std::invalid_argument(
            fmt::format("needs 0 < lag_min < lag_max and lag_step > 0 (diameters), not {} to {} by "
                        "{}",
                        o.lag_min, o.lag_max, o.lag_step));
    }
    if (!(o.smoothing > 0 && 2 * o.smoothing * record.diameter < record.length)) {
        throw std::invalid_argument(
            fmt::format("smoothing must be > 0 and less than half the pipe of {:g} diameters, not "
                        "{}",
                        record.length / record.diameter, o.smoothing));
    }
}

std::vector<std::size_t> lags_in_frames(const PipeRecord& record, const PipeOverlapOptions& o) {
    std::vector<std::size_t> lags;
    const double speed = std::abs(record.mean_speed());
    if (speed == 0) return lags;
    const double longest = std::min(o.lag_max * record.diameter, 0.4 * record.length);
    const double block = static_cast<double>(record.frames() / pipe_blocks);
    for (int step = 0;; ++step) {
        const double way = (o.lag_min + step * o.lag_step) * record.diameter;
        if (way > longest) break;
        const double frames = std::round(way / speed / record.interval);
        if (frames + 1 > block) break;
        const auto lag = static_cast<std::size_t>(frames);
        if (lag > 0 && (lags.empty() || lag > lags.back())) lags.push_back(lag);
    }
    return lags;
}

/// Every block is a sample; references are as many as are not too close to be independent.
void add_references(const PipeRecord& record, const std::vector<std::size_t>& lags,
                    OverlapVelocity& overlap) {
    constexpr std::size_t most_references = 200;  // per block
    const auto field = [&](std::size_t t) {
        return overlap.smoothed(record.field(pipe_blocks, t));
    };
    const std::size_t references = record.frames() / pipe_blocks - lags.back();
    const std::size_t stride = (references + most_references - 1) / most_references;
    for (std::size_t t = 0; t < references; t += stride) {
        const std::vector<float> reference = field(t);
        overlap.add(0, reference, reference);
        for (std::size_t k = 0; k < lags.size(); ++k)
            overlap.add(k + 1, reference, field(t + lags[k]));
    }
}

}  // namespace

std::optional<OverlapVelocity> pipe_overlap(const PipeRecord& record,
                                            const PipeOverlapOptions& options) {
    check(record, options);
    const auto lags = lags_in_frames(record, options);
    if (lags.size() < 3) return std::nullopt;
    OverlapVelocity overlap(record.in_blocks(pipe_blocks),
                            {.lags = lags,
                             .smoothing = options.smoothing * record.diameter,
                             .band = {0, std::numeric_limits<double>::infinity()},
                             .expected = {{record.mean_speed(), search_reach * record.diameter}}});
    add_references(record, lags, overlap);
    return overlap;
}

}  // namespace crossgrain::measure
