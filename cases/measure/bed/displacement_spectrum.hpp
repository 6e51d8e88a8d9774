// Power spectrum of grain displacements in layers of a vibrated bed
// (Taguchi, chao-dyn/9405003 (1994), Eqs. 3-5).
//
//   dx_i^(n)   = x_i(t_{n+1}) - x_i(t_n)                                         (3)
//   dx_{X,Y}   = sum of dx_i over the grains i in cell (X, Y) at t_n             (4)
//   S(K, Y)    = < | sum_X dx_{X,Y} exp(-2 pi i X K/L) |^2 >_n,  L = L_h/d       (5)
//
// Readings where the paper leaves a choice:
// - t_n: the spacing of lid and bottom crosses h0 upwards (option: downwards), at most once per
//   half period of the bottom. Upwards the bed is in flight; downwards the lowest row is pressed
//   into the bottom and many grains fall into layer 0. Option `either`, the paper's words taken
//   literally ("when the spacing has some definite value"): at most once per quarter period.
// - Positions at t_n: cubic Hermite interpolation between the two frames around the crossing (error
//   O(interval^4) while no contact begins or ends in between).
// - Cells are d wide and sqrt(3) d/2 high and move with the bottom:
//   X = floor(x/d + 1/2) modulo L, Y = floor((y - y_bottom)/(sqrt(3) d/2)) + 1. The cell height
//   printed in the paper, d, would leave its layers 16-20 empty.
// - S is averaged over the layers of a group, then log S is fitted against log K.
//
// Errors: standard error by the jackknife over displacement vectors (delete one). Successive
// vectors share the end point of one and the start of the next and may be correlated: the setting
// `stderr_blocks_of_two` is the same error with neighbouring pairs of vectors deleted together; if
// it is much larger, the standard error is too small. Systematic error: half the spread of the
// slope over the fit window and the windows K = 1-8, 1-16 and 1-32; 0 for the slope of the tail.
#pragma once

#include "cases/measure/bed/layer_spectrum.hpp"
#include "cases/measure/estimator.hpp"
#include "cases/measure/options.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::measure {

enum class Crossing { upward, downward, either };
constexpr auto words(Crossing /*of*/) {
    return std::array{"upward", "downward", "either"};
}

/// Layers first..last, averaged together.
struct LayerGroup {
    int first = 1;
    int last = 1;
};

struct DisplacementSpectrumOptions {
    double spacing = 0;
    Crossing crossing = Crossing::upward;
    double skip = 0;
    int k_min = 1;
    int k_max = 16;
    int tail_min = 17;  ///< fit window of the tail's slope
    int tail_max = 32;
    std::vector<LayerGroup> groups = {{1, 5}, {6, 10}, {11, 15}, {16, 20}};
};

inline OptionKeys option_keys(DisplacementSpectrumOptions& o) {
    const Range wave_number = Range::whole(1, 1'000'000);
    return {
        {"spacing", &o.spacing, Range::positive(), "h0 (l) of lid and bottom at t_n"},
        {"skip", &o.skip, Range::not_negative(), "crossings before this time (t) are not counted"},
        {"crossing", WordOption(o.crossing), {}, "in which direction h0 is crossed"},
        {"k_min", &o.k_min, wave_number, "first K of the fit window of the slope"},
        {"k_max", &o.k_max, wave_number, "last K of that window, > k_min"}};
}

/// Measurements: `slope_<first>_<last>` per group (1), settings k_min, k_max, vectors and, from six
/// vectors on, stderr_blocks_of_two; `slope_<first>_<last>_K1_<k>`, the same over K = 1-k for k = 8
/// and 32; `slope_tail_<first>_<last>`, the same over the tail window (0 for white noise);
/// `displacement_vectors`, their number. n is the number of vectors.
/// Series "spectrum": K = 1..L/2 and per group S_<first>_<last>, err_<first>_<last>;
/// "spectrum-fit": per group layer_first, layer_last, k_min, k_max, exponent, exponent_err,
/// amplitude; "displacement-field": x (within the period), y (above the bottom), dx, dy of every
/// grain for the last vector.
/// With crossings other than upward all names end in "_downward" or "_either" (series
/// "-downward", "-either").
///
/// Without a vector (h0 is crossed less than twice) nothing is reported, with fewer than three only
/// `displacement_vectors`. A group with a layer-
/// averaged S of zero anywhere in a window (empty layers) gives no slope; a window beyond L/2 gives
/// none either. Nothing for scenes without bottom, lid or period, or whose period is not a whole
/// number of diameters. Throws std::invalid_argument for an option out of range, and
/// unless k_min < k_max, 1 <= tail_min < tail_max, and every group has 1 <= first <= last.
class DisplacementSpectrum final : public Estimator {
  public:
    using Options = DisplacementSpectrumOptions;
    DisplacementSpectrum(const scene::Scene& scene, DisplacementSpectrumOptions options);
    void add(const scene::Frame& frame) override;
    void finish(Results& results) override;

  private:
    struct FitWindow {
        int k_min, k_max;
    };
    /// What is kept of a frame to interpolate. Arrays have shape (grains).
    struct Instant {
        double time = 0;
        scene::LidState lid;
        double spacing = 0;
        std::vector<double> x, y, vx, vy;
    };
    struct Positions {
        double time = 0;
        std::vector<double> x, y;
    };

    void store(const scene::Frame& frame, Instant& instant) const;
    [[nodiscard]] double spacing_at(double time, const Instant& a, const Instant& b) const;
    [[nodiscard]] std::optional<double> crossing_time(const Instant& a, const Instant& b) const;
    [[nodiscard]] Positions interpolate(double time, const Instant& a, const Instant& b) const;
    void add_vector(const Positions& start, const Positions& end);
    /// The name of a measurement or series, with the kind of crossing after `joint`.
    [[nodiscard]] std::string named(const std::string& name, char joint = '_') const;
    void add_slope(std::size_t group, FitWindow window, const std::string& name,
                   bool with_systematic, Results& results) const;
    void keep_field(const Positions& start, const Positions& end);
    void add_series(Results& results) const;
    void add_fits(Results& results) const;

    DisplacementSpectrumOptions options_;
    double diameter_ = 0;
    scene::Plates plates_;
    std::optional<LayerSpectrum> spectrum_;  ///< absent if the scene cannot be measured
    std::optional<Instant> previous_;
    Instant current_;
    std::optional<Positions> start_;
    std::vector<std::vector<double>> field_;  ///< x, y, dx, dy of the last vector; or empty
    /// S averaged over the layers of a group, shape (groups)(vectors, K).
    std::vector<std::vector<std::vector<double>>> group_spectra_;
};

}  // namespace crossgrain::measure
