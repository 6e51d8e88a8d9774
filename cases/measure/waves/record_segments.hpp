// Cuts the bin counts of an ensemble into segments of M frames and hands them out as time series,
// two at a time as the real and the imaginary part of one complex series, as a transform takes
// them. One segment is held in memory: 2 bytes x bins x samples x M.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace crossgrain::measure {

/// Which of the bins are looked at: first..last, counted from the top.
struct BinRange {
    std::size_t first = 0;
    std::size_t last = 0;
    [[nodiscard]] std::size_t size() const noexcept { return last - first + 1; }
};

class RecordSegments {
  public:
    /// `points` is M, even.
    RecordSegments(BinRange bins, std::size_t samples, std::size_t points);

    /// `counts` has shape (bins of the pipe, samples). Returns true when the segment is full; it
    /// can then be read until the next frame begins a new one.
    bool add(std::span<const std::uint16_t> counts);

    /// Series are numbered bin * samples + sample, bins from that of the range's first on; the
    /// last pair may hold one only.
    [[nodiscard]] std::size_t series() const noexcept { return bins_.size() * samples_; }
    [[nodiscard]] std::size_t pairs() const noexcept { return (series() + 1) / 2; }
    [[nodiscard]] std::size_t points() const noexcept { return points_; }

    /// Series 2 pair (real) and 2 pair + 1 (imaginary, 0 if there is none), each minus its mean
    /// over the segment and, if `running_mean` > 1 (frames, odd), minus the mean over that many
    /// frames around each frame, as far as they are in the segment. Shape of `out`: (points).
    void pair(std::size_t pair, std::size_t running_mean, std::span<std::complex<float>> out);

    /// Adds the counts of a series times `factor` to `out`, shape (points).
    void add_to(std::size_t series, std::complex<float> factor,
                std::span<std::complex<float>> out) const;

  private:
    static constexpr std::size_t tile_ = 16;  ///< series side by side: half a cache line

    BinRange bins_;
    std::size_t samples_, points_;
    std::size_t filled_ = 0;
    std::vector<std::uint16_t> counts_;  ///< shape (tiles, points, tile_)
    std::vector<std::complex<double>> sums_;
};

}  // namespace crossgrain::measure
