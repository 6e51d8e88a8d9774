// Energy spectrum of the velocities across the drive, row by row of a lattice
// (Taguchi, chao-dyn/9405003 (1994), Eq. 6).
//
//   E(K, t) = < | sum_i v_x(t; i, j) exp(-2 pi i K i/L) |^2 >_j
//
// with v_x(t; i, j) the velocity of grain i of row j, whatever has become of its place. The average
// over initial states is that over replicas.
//
// Read at stated times, at stated phases of the drive (averaged over the passages), and over a
// window of time, in which every spectrum is divided by its sum before it is averaged: where the
// motion dies away, its beginning would decide alone.
//
// Errors: standard error by the jackknife, at a time over the rows (neighbouring rows move
// together: too small; replicas tell), at a phase over the passages, over a window over the periods
// of the drive. Systematic error: half the spread of the slope over the fit window and the windows
// K = 1-8, 1-16 and 1-32.
#pragma once

#include "cases/measure/bed/lattice_rows.hpp"
#include "cases/measure/bed/layer_spectrum.hpp"
#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"

#include <optional>
#include <string>
#include <vector>

namespace crossgrain::measure {

struct VelocitySpectrumOptions {
    double clock = 0;
    std::vector<double> times = {};
    std::vector<double> phases = {};
    double skip = 0;
    std::optional<double> from, to;
    int k_min = 1;
    int k_max = 16;
};

inline OptionKeys option_keys(VelocitySpectrumOptions& o) {
    const Range wave_number = Range::whole(1, 1'000'000);
    return {{"clock", &o.clock, {}, "what the paper's clock shows at the start (t)"},
            {"at", &o.times, {}, "times (t) by the paper's clock"},
            {"phases", &o.phases, Range::right_open(0, 360),
             "2 pi t/T of the drive by the paper's clock, in degrees"},
            {"skip", &o.skip, Range::not_negative(),
             "passages of a phase before this time (t) do not count"},
            {"from", &o.from, {}, "start of the window (t) by the paper's clock, with 'to'"},
            {"to", &o.to, {}, "end of the window (t), > from"},
            {"k_min", &o.k_min, wave_number, "first K of the fit window of the slopes"},
            {"k_max", &o.k_max, wave_number, "last K of that window, > k_min"}};
}

/// Labels: `t<time>`, `phase<degrees>`, `window`. Per label the measurements
///   velocity_slope_<label>          over k_min..k_max, settings k_min, k_max, t (mean time read)
///   velocity_slope_<label>_K1_<k>   over the stated windows, k = 8, 16, 32
///   transverse_energy_<label>       mean m v_x^2/2 per grain
/// n is the number of rows, passages or periods. With phases also `velocity_slope_flattest` and
/// `velocity_slope_steepest`, the slopes of the phases where it is largest and least, setting
/// phase. Series "velocity-spectrum": K and per label E_<label>; "velocity-slope": t (the paper's
/// clock), slope_K1_8, slope_K1_16, slope_K1_32, transverse_energy of every frame (rows without a
/// slope are left out).
///
/// A time is read at the nearest frame, at most half an interval away; one outside of the run is
/// not reported. Nothing for scenes that do not start from rows of a lattice. Throws
/// std::invalid_argument for an option out of range, and unless k_min < k_max and `from` < `to` are
/// given both or neither.
class VelocitySpectrum final : public Estimator {
  public:
    using Options = VelocitySpectrumOptions;
    VelocitySpectrum(const scene::Scene& scene, VelocitySpectrumOptions options);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    /// What is collected under one label.
    struct Reading {
        std::string label;
        std::vector<std::vector<double>> samples;  ///< spectra, shape (samples, K)
        double time_sum = 0, energy_sum = 0;
        std::size_t frames = 0;
    };
    /// One frame, as it is measured.
    struct Instant {
        double time = 0;  ///< by the paper's clock
        double transverse_energy = 0;
        std::vector<std::vector<double>> row_spectra;  ///< shape (rows, K)
        std::vector<double> mean;                      ///< over the rows, shape (K)
    };

    [[nodiscard]] Instant measure(const scene::Frame& frame);
    [[nodiscard]] bool is_at(double time, const Instant& instant) const;
    void read_times(const Instant& instant);
    void read_phases(const Instant& instant);
    void read_window(const Instant& instant);
    void follow_slope(const Instant& instant);
    void add_measurements(const Reading& reading, Results& results) const;
    void add_extremes(Results& results) const;
    void add_series(Results& results) const;

    VelocitySpectrumOptions options_;
    std::optional<LatticeRows> rows_;  ///< absent if the scene cannot be measured
    double mass_ = 0;
    double interval_ = 0;  ///< between frames (t)
    std::optional<double> period_;
    std::optional<LayerSpectrum> spectrum_;
    std::vector<Reading> times_, phases_;
    Reading window_;
    std::vector<std::vector<double>> slope_columns_;
};

}  // namespace crossgrain::measure
