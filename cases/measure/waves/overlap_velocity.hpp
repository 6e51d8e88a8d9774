// Velocity of a density pattern in real space by maximal overlap (Peng & Herrmann 1995, section
// III.C, Fig. 5): from a reference field on, the shift at which a later field overlaps it most
// grows as v T with the interval T.
//
// Fields are first averaged over a smoothing length: otherwise single particles decide the overlap.
// The overlap functions of all references are added, the shift of their maximum is followed over
// the intervals (unwrapped around the pipe), and v is the slope of the straight line through the
// shifts, intercept free: of all samples together for the velocity, of each alone for the share of
// the samples in which something travels. Whether it does is decided by shift_line.hpp: shifts of
// white noise are uniform on the pipe, and those of n intervals lie within a smoothing length s of
// some line with a probability of about (2 s/L)^(n - 2); measured for n = 5 and 2 s/L = 0.2: 0.013
// of samples, 0.006 of records.
#pragma once

#include "cases/measure/results.hpp"
#include "cases/measure/statistics/shift_line.hpp"
#include "cases/measure/waves/binned_record.hpp"
#include "cases/measure/waves/mode_spectrum.hpp"

#include <optional>
#include <span>
#include <vector>

namespace crossgrain::measure {

struct OverlapOptions {
    std::vector<std::size_t> lags;  ///< fields, ascending, > 0, at least three
    double smoothing = 0;           ///< in the record's unit of length, in (0, L/2)
    SpeedBand band;                 ///< what travels at another speed is no wave
    /// A pipe may hold several patterns that look alike: the greatest overlap is looked for within
    /// `reach` of where it is expected, first where `speed` leads, then on the line so far.
    struct Expectation {
        double speed = 0, reach = 0;
    };
    std::optional<Expectation> expected;
};

class OverlapVelocity {
  public:
    /// Throws std::invalid_argument for fewer than three lags or a smoothing out of range.
    OverlapVelocity(BinnedRecord record, OverlapOptions options);

    /// n_i minus its mean over the pipe, smoothed; shape (bins, samples) in and out.
    [[nodiscard]] std::vector<float> smoothed(std::span<const std::uint16_t> counts) const;
    /// Of smoothed fields: `lag` 0 for a reference with itself, k for the later field at lags[k-1].
    void add(std::size_t lag, std::span<const float> reference, std::span<const float> later);

    /// The line through the shifts of all samples together if these are a wave; else of those that
    /// have a wave of their own, if they are more than noise would have (binomial, at 0.001, for
    /// twice the probability above); else of all. Then the same without one of the groups.
    [[nodiscard]] ShiftLine line() const;
    [[nodiscard]] ShiftLine line_without(std::size_t group) const;
    /// Parts for the jackknife: up to 16, each of successive samples.
    [[nodiscard]] std::size_t groups() const;
    [[nodiscard]] bool in_band(const ShiftLine& line) const;

    /// Appends the series "overlap": T, shift and err (all samples together; jackknife), height (of
    /// the overlap over that of the reference with itself), and `overlap_wave_fraction`, the share
    /// of the samples with a wave of their own. Returns in how many others a pattern travels at a
    /// speed outside the band.
    std::size_t append_share(Results& results) const;

    /// Appends `overlap_velocity`, along gravity, of line(), n its samples, if it is a wave of two
    /// samples or more: error by the jackknife over the groups; settings lag_min, lag_max,
    /// smoothing, share (of the samples that count). Returns whether it did.
    bool append_velocity(Results& results) const;

  private:
    using Weights = std::vector<double>;  ///< shape (samples)
    /// Of line(): 1 for the samples that count, 0 for the others.
    [[nodiscard]] Weights counting() const;
    [[nodiscard]] Weights without(Weights weights, std::size_t group) const;
    [[nodiscard]] Weights only(std::size_t sample) const;
    [[nodiscard]] std::vector<float> overlap(std::size_t lag, const Weights& weights) const;
    [[nodiscard]] std::vector<double> shifts(const Weights& weights) const;
    [[nodiscard]] ShiftLine line_of(const Weights& weights) const;
    [[nodiscard]] Series series() const;

    BinnedRecord record_;
    OverlapOptions options_;
    std::size_t rows_;           ///< bins of the smoothing
    std::vector<double> times_;  ///< of the lags
    std::vector<float> sums_;    ///< shape (1 + lags, bins, samples)
};

}  // namespace crossgrain::measure
