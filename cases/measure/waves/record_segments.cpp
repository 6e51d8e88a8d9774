#include "cases/measure/waves/record_segments.hpp"

#include <algorithm>

namespace crossgrain::measure {

RecordSegments::RecordSegments(BinRange bins, std::size_t samples, std::size_t points)
    : bins_(bins), samples_(samples), points_(points) {
    counts_.assign((series() + tile_ - 1) / tile_ * tile_ * points_, 0);
}

bool RecordSegments::add(std::span<const std::uint16_t> counts) {
    if (filled_ == points_) filled_ = 0;
    const auto wanted = counts.subspan(bins_.first * samples_, series());
    for (std::size_t s = 0; s < wanted.size(); s += tile_) {
        const auto part = wanted.subspan(s, std::min(tile_, wanted.size() - s));
        std::ranges::copy(part, &counts_[s * points_ + filled_ * tile_]);
    }
    return ++filled_ == points_;
}

void RecordSegments::pair(std::size_t pair, std::size_t running_mean,
                          std::span<std::complex<float>> out) {
    const std::size_t tile = 2 * pair / tile_, column = 2 * pair % tile_;
    const std::uint16_t* counts = &counts_[tile * tile_ * points_ + column];
    std::uint64_t first = 0, second = 0;
    for (std::size_t t = 0; t < points_; ++t) {
        first += counts[t * tile_];
        second += counts[t * tile_ + 1];
    }
    const auto n = static_cast<double>(points_);
    const auto mean_1 = static_cast<float>(static_cast<double>(first) / n);
    const auto mean_2 = static_cast<float>(static_cast<double>(second) / n);
    for (std::size_t t = 0; t < points_; ++t) {
        out[t] = {static_cast<float>(counts[t * tile_]) - mean_1,
                  static_cast<float>(counts[t * tile_ + 1]) - mean_2};
    }
    if (running_mean <= 1) return;
    sums_.assign(points_ + 1, 0.0);
    for (std::size_t t = 0; t < points_; ++t)
        sums_[t + 1] = sums_[t] + std::complex<double>(out[t]);
    const std::size_t half = running_mean / 2;
    for (std::size_t t = 0; t < points_; ++t) {
        const std::size_t from = t < half ? 0 : t - half, to = std::min(points_, t + half + 1);
        const auto mean = (sums_[to] - sums_[from]) / static_cast<double>(to - from);
        out[t] -= std::complex<float>(mean);
    }
}

void RecordSegments::add_to(std::size_t series, std::complex<float> factor,
                            std::span<std::complex<float>> out) const {
    const std::uint16_t* counts = &counts_[series / tile_ * tile_ * points_ + series % tile_];
    for (std::size_t t = 0; t < points_; ++t)
        out[t] += factor * static_cast<float>(counts[t * tile_]);
}

}  // namespace crossgrain::measure
