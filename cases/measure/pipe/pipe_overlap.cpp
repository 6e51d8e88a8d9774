#include "cases/measure/pipe/pipe_overlap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

/// Whole bins further than `reach` from the expected shift are out of the question.
std::vector<float> within(std::vector<float> overlap, double expected, double reach) {
    const auto bins = static_cast<double>(overlap.size());
    const float least = std::ranges::min(overlap);
    for (std::size_t s = 0; s < overlap.size(); ++s) {
        const double away = static_cast<double>(s) - expected;
        if (std::abs(away - bins * std::round(away / bins)) > reach) overlap[s] = least;
    }
    return overlap;
}

}  // namespace

std::optional<PipeOverlap> PipeOverlap::of(const PipeRecord& record,
                                           const PipeOverlapOptions& options) {
    check(record, options);
    auto lags = lags_in_frames(record, options);
    if (lags.size() < 3) return std::nullopt;
    return PipeOverlap(record, options, std::move(lags));
}

PipeOverlap::PipeOverlap(const PipeRecord& record, const PipeOverlapOptions& options,
                         std::vector<std::size_t> lags)
    : length_(record.length), bin_(record.bin), smoothing_(options.smoothing * record.diameter),
      speed_(record.mean_speed()),
      reach_(search_reach * record.diameter), shape_{record.bins, pipe_blocks},
      rows_(static_cast<std::size_t>(std::max(1.0, std::round(smoothing_ / record.bin)))),
      lags_(std::move(lags)), overlaps_((lags_.size() + 1) * shape_.size(), 0.0F) {
    for (const std::size_t lag : lags_)
        times_.push_back(static_cast<double>(lag) * record.interval);
    add_references(record);
}

void PipeOverlap::add_references(const PipeRecord& record) {
    constexpr std::size_t most_references = 200;  // per block; more are hardly independent
    const std::size_t length = record.frames() / pipe_blocks;
    // Frame f of every block, side by side.
    const auto field = [&](std::size_t f) {
        std::vector<std::uint16_t> counts(shape_.size());
        for (std::size_t b = 0; b < pipe_blocks; ++b) {
            const auto here = record.count_at(b * length + f);
            for (std::size_t i = 0; i < shape_.bins; ++i)
                counts[i * pipe_blocks + b] = here[i];
        }
        return fluctuation(shape_, std::span<const std::uint16_t>(counts), rows_);
    };
    const std::size_t references = length - lags_.back();
    const std::size_t stride = (references + most_references - 1) / most_references;
    for (std::size_t f = 0; f < references; f += stride) {
        const std::vector<float> reference = field(f);
        const auto sums = [&](std::size_t at) {
            return std::span(overlaps_).subspan(at * shape_.size(), shape_.size());
        };
        add_overlap(shape_, reference, reference, sums(0));
        for (std::size_t k = 0; k < lags_.size(); ++k)
            add_overlap(shape_, reference, field(f + lags_[k]), sums(k + 1));
    }
}

/// Shape (bins); lag 0 is the overlap of the references with themselves.
std::vector<float> PipeOverlap::overlap_of(std::size_t lag,
                                           const std::vector<double>& weights) const {
    std::vector<float> sum(shape_.bins);
    for (std::size_t i = 0; i < shape_.bins; ++i) {
        const float* blocks = &overlaps_[lag * shape_.size() + i * pipe_blocks];
        double weighted = 0;
        for (std::size_t b = 0; b < pipe_blocks; ++b)
            weighted += weights[b] * static_cast<double>(blocks[b]);
        sum[i] = static_cast<float>(weighted);
    }
    return sum;
}

// The first is looked for around the way of the grains, each further one around the line from the
// origin through the last.
std::vector<double> PipeOverlap::shifts(const std::vector<double>& weights) const {
    std::vector<double> shifts;
    const FieldShape one{shape_.bins, 1};
    double expected = speed_ * times_.front();
    for (std::size_t k = 0; k < lags_.size(); ++k) {
        if (k > 0) expected = shifts.back() * times_[k] / times_[k - 1];
        const auto overlap = within(overlap_of(k + 1, weights), expected / bin_, reach_ / bin_);
        const double shift = best_shift(one, overlap, 0, rows_).refined * bin_;
        shifts.push_back(shift + length_ * std::round((expected - shift) / length_));
    }
    return shifts;
}

ShiftLine PipeOverlap::line_of(const std::vector<double>& weights) const {
    return shift_line(times_, shifts(weights), smoothing_);
}

ShiftLine PipeOverlap::line() const {
    return line_of(std::vector<double>(pipe_blocks, 1.0));
}

ShiftLine PipeOverlap::line_without(std::size_t block) const {
    std::vector<double> weights(pipe_blocks, 1.0);
    weights[block] = 0;
    return line_of(weights);
}

ShiftLine PipeOverlap::line_of(std::size_t block) const {
    std::vector<double> weights(pipe_blocks, 0.0);
    weights[block] = 1;
    return line_of(weights);
}

Series PipeOverlap::series() const {
    const std::vector<double> all(pipe_blocks, 1.0);
    const double self = double{overlap_of(0, all).front()};
    Series series{.name = "overlap",
                  .columns = {"T", "shift", "height"},
                  .values = {times_, shifts(all), {}},
                  .units = {"t", "l", "1"}};
    for (std::size_t k = 0; k < lags_.size(); ++k) {
        const double height = double{std::ranges::max(overlap_of(k + 1, all))};
        series.values[2].push_back(self > 0 ? height / self : 0.0);
    }
    return series;
}

}  // namespace crossgrain::measure
