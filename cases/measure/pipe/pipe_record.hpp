// Density and flux of grains along a pipe, bin by bin and frame by frame, from which the density
// waves are measured once the run is over: only then is the mean velocity known that sets the
// intervals and frequencies to look at. Bins are counted downwards, so that what falls moves
// towards larger indices. 6 bytes per bin and frame; no positions are kept.
#pragma once

#include "cases/measure/options.hpp"
#include "cases/measure/pipe/pipe_section.hpp"
#include "cases/measure/results.hpp"
#include "cases/measure/waves/binned_record.hpp"
#include "cases/scene/frame.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::measure {

struct PipeRecordOptions {
    double skip = 0;
    double bin = 5;
};

inline OptionKeys option_keys(PipeRecordOptions& o) {
    return {{"skip", &o.skip, Range::not_negative(), "frames before this time (t) are left out"},
            {"bin", &o.bin, Range::positive(), "in diameters, rounded so that bins fill the pipe"}};
}

struct PipeRecord {
    double length = 0;    ///< L (l)
    double bin = 0;       ///< b = L/bins (l)
    double interval = 0;  ///< T between frames (t)
    double diameter = 0;  ///< (l)
    std::size_t bins = 0;
    std::vector<double> times;
    std::vector<std::uint16_t> count;  ///< n_i, shape (frames, bins)
    std::vector<float> flux;           ///< sum of the downward velocities in bin i, the same shape

    [[nodiscard]] std::size_t frames() const noexcept { return times.size(); }
    [[nodiscard]] std::span<const std::uint16_t> count_at(std::size_t frame) const {
        return std::span(count).subspan(frame * bins, bins);
    }
    [[nodiscard]] std::span<const float> flux_at(std::size_t frame) const {
        return std::span(flux).subspan(frame * bins, bins);
    }
    /// Mean downward velocity of the grains over the frames first..last-1; 0 without grains.
    [[nodiscard]] double mean_speed(std::size_t first, std::size_t last) const;
    [[nodiscard]] double mean_speed() const { return mean_speed(0, frames()); }

    /// The record cut into `samples` blocks of frames()/samples frames as the estimators of waves
    /// read it: field `t` holds frame t of every block, side by side, shape (bins, samples).
    [[nodiscard]] BinnedRecord in_blocks(std::size_t samples) const;
    [[nodiscard]] std::vector<std::uint16_t> field(std::size_t samples, std::size_t t) const;
};

class PipeRecorder {
  public:
    /// Throws std::invalid_argument for a scene that is no pipe, fewer than 16 bins, or a
    /// bin that is not > 0.
    PipeRecorder(const scene::Scene& scene, PipeRecordOptions options);
    void add(const scene::Frame& frame);
    [[nodiscard]] const PipeRecord& record() const noexcept { return record_; }
    [[nodiscard]] const PipeSection& section() const noexcept { return section_; }

  private:
    PipeSection section_;
    double skip_;
    PipeRecord record_;
};

/// Frames first..last-1.
struct FrameBlock {
    std::size_t first = 0, last = 0;
};

/// A record cut into equal parts, the last one taking what is left over. Errors of what is measured
/// from a whole run are jackknives over these.
[[nodiscard]] std::vector<FrameBlock> equal_blocks(std::size_t frames, std::size_t blocks);

inline constexpr std::size_t pipe_blocks = 8;
inline constexpr std::size_t fewest_pipe_frames = 128;  ///< 16 per block

/// Set if grains cross a bin between two frames, V T >= b: spectra in time are then aliased, and a
/// wave looks like white noise. What is measured from them is refused.
[[nodiscard]] std::optional<Finding> too_coarse_sampling(const PipeRecord& record);

}  // namespace crossgrain::measure
