// Velocity of a density pattern of grains by maximal overlap, as gas_overlap.hpp does it for an
// ensemble of lattice gases (Peng & Herrmann 1995, section III.C): here one run is cut into blocks.
// Intervals are those in which grains fall a given way at their mean velocity, so that they suit
// every density. The greatest overlap is looked for within 100 diameters of where it is expected (a
// pipe may hold several waves that look alike): first where the grains are, then on the line so
// far.
//
// Single grains, which move at their own velocity, pull early shifts towards it; the shortest
// interval must be long enough for them to have parted from the wave.
#pragma once

#include "cases/measure/gas/gas_shift.hpp"
#include "cases/measure/options.hpp"
#include "cases/measure/pipe/pipe_record.hpp"
#include "cases/measure/statistics/shift_line.hpp"

#include <optional>
#include <vector>

namespace crossgrain::measure {

/// All in diameters.
struct PipeOverlapOptions {
    double lag_min = 30;
    double lag_max = 90;
    double lag_step = 10;
    double smoothing = 20;
};

inline OptionKeys option_keys(PipeOverlapOptions& o) {
    return {{"lag_min", &o.lag_min, Range::positive(),
             "way fallen in the shortest interval, in diameters"},
            {"lag_max", &o.lag_max, Range::positive(),
             "in the longest, > lag_min; at most 0.4 L is used"},
            {"lag_step", &o.lag_step, Range::positive(), "between them, in diameters"},
            {"smoothing", &o.smoothing, Range::positive(),
             "of the fields, in diameters: single grains in passing must not decide"}};
}

class PipeOverlap {
  public:
    /// Nothing for a gas at rest on average, or if the frames give fewer than three different
    /// intervals that fit into a block. Throws std::invalid_argument for options that make no
    /// sense.
    [[nodiscard]] static std::optional<PipeOverlap> of(const PipeRecord& record,
                                                       const PipeOverlapOptions& options);

    /// The line through the shifts of all blocks together, without one, or of one block (l/t,
    /// downwards).
    [[nodiscard]] ShiftLine line() const;
    [[nodiscard]] ShiftLine line_without(std::size_t block) const;
    [[nodiscard]] ShiftLine line_of(std::size_t block) const;

    /// Columns T, shift (l), height (of the overlap over that of a field with itself).
    [[nodiscard]] Series series() const;

  private:
    PipeOverlap(const PipeRecord& record, const PipeOverlapOptions& options,
                std::vector<std::size_t> lags);
    void add_references(const PipeRecord& record);
    [[nodiscard]] std::vector<float> overlap_of(std::size_t lag,
                                                const std::vector<double>& weights) const;
    [[nodiscard]] std::vector<double> shifts(const std::vector<double>& weights) const;
    [[nodiscard]] ShiftLine line_of(const std::vector<double>& weights) const;

    double length_, bin_, smoothing_;  ///< (l)
    double speed_;                     ///< of the grains (l/t)
    double reach_;                     ///< how far around an expected shift is looked (l)
    FieldShape shape_;                 ///< one block as one replica
    std::size_t rows_;                 ///< bins of the smoothing
    std::vector<std::size_t> lags_;    ///< frames, ascending
    std::vector<double> times_;        ///< the same (t)
    std::vector<float> overlaps_;      ///< shape (1 + lags, bins, blocks)
};

}  // namespace crossgrain::measure
