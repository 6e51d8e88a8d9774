#include "cases/measure/bed/displacement_spectrum.hpp"

#include "cases/measure/bed/plate_motion.hpp"
#include "cases/measure/statistics/hermite.hpp"
#include "cases/measure/statistics/power_law.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace crossgrain::measure {
namespace {

void check(const DisplacementSpectrumOptions& options) {
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw std::invalid_argument(fmt::format("displacement spectrum: {}", what));
    };
    check_ranges(options);
    require(options.k_max > options.k_min, "needs k_min < k_max");
    require(options.tail_min >= 1 && options.tail_max > options.tail_min,
            "needs 1 <= tail_min < tail_max");
    require(!options.groups.empty(), "needs at least one group of layers");
    for (const LayerGroup& group : options.groups) {
        require(group.first >= 1 && group.last >= group.first,
                "a group of layers needs 1 <= first <= last");
    }
}

// L_h/d if it is a whole number.
std::optional<std::size_t> cells_per_period(const scene::Scene& scene) {
    if (!scene.periodic_x) return std::nullopt;
    const double ratio = *scene.periodic_x / scene.grains.diameter;
    const double whole = std::round(ratio);
    // Both are decimal numbers of the case; only their rounding is forgiven.
    if (whole < 2 || std::abs(ratio - whole) > 1e-9 * ratio) return std::nullopt;
    return static_cast<std::size_t>(whole);
}

std::string label(const LayerGroup& group) {
    return fmt::format("{}_{}", group.first, group.last);
}

}  // namespace

DisplacementSpectrum::DisplacementSpectrum(const scene::Scene& scene,
                                           DisplacementSpectrumOptions options)
    : options_(std::move(options)), diameter_(scene.grains.diameter), plates_(scene.plates),
      group_spectra_(options_.groups.size()) {
    check(options_);
    const auto cells = cells_per_period(scene);
    const bool has_lid = !std::holds_alternative<std::monostate>(plates_.lid);
    if (cells && plates_.bottom && has_lid) spectrum_.emplace(*cells);
}

void DisplacementSpectrum::store(const scene::Frame& frame, Instant& instant) const {
    instant.time = frame.time;
    instant.lid = lid_state(plates_, frame).value_or(scene::LidState{});
    instant.spacing = instant.lid.height - plate_state(*plates_.bottom, frame.time).height;
    instant.x.assign(frame.x.begin(), frame.x.end());
    instant.y.assign(frame.y.begin(), frame.y.end());
    instant.vx.assign(frame.vx.begin(), frame.vx.end());
    instant.vy.assign(frame.vy.begin(), frame.vy.end());
}

double DisplacementSpectrum::spacing_at(double time, const Instant& a, const Instant& b) const {
    const double h = b.time - a.time;
    const double lid =
        hermite((time - a.time) / h, h, a.lid.height, a.lid.velocity, b.lid.height, b.lid.velocity);
    return lid - plate_state(*plates_.bottom, time).height;
}

std::optional<double> DisplacementSpectrum::crossing_time(const Instant& a,
                                                          const Instant& b) const {
    const double h0 = options_.spacing;
    const bool upwards = options_.crossing == Crossing::upward ||
                         (options_.crossing == Crossing::either && a.spacing < h0);
    const double sign = upwards ? 1.0 : -1.0;
    if (!(sign * (a.spacing - h0) < 0 && sign * (b.spacing - h0) >= 0)) return std::nullopt;
    // Bisection to the last bit: safe for whatever the lid does within the interval.
    double before = a.time, after = b.time;
    for (int i = 0; i < 60; ++i) {
        const double middle = (before + after) / 2;
        (sign * (spacing_at(middle, a, b) - h0) < 0 ? before : after) = middle;
    }
    return after;
}

DisplacementSpectrum::Positions DisplacementSpectrum::interpolate(double time, const Instant& a,
                                                                  const Instant& b) const {
    const double h = b.time - a.time;
    const double s = (time - a.time) / h;
    Positions positions{.time = time, .x = a.x, .y = a.y};
    for (std::size_t i = 0; i < a.x.size(); ++i) {
        positions.x[i] = hermite(s, h, a.x[i], a.vx[i], b.x[i], b.vx[i]);
        positions.y[i] = hermite(s, h, a.y[i], a.vy[i], b.y[i], b.vy[i]);
    }
    return positions;
}

void DisplacementSpectrum::add(const scene::Frame& frame) {
    if (!spectrum_) return;
    store(frame, current_);
    if (previous_) {
        const auto time = crossing_time(*previous_, current_);
        // The least time between crossings; a bottom at rest has no period to speak of.
        const double share = options_.crossing == Crossing::either ? 0.25 : 0.5;
        const double least = plates_.bottom->amplitude > 0 ? plates_.bottom->period * share : 0.0;
        if (time && *time >= options_.skip && (!start_ || *time - start_->time >= least)) {
            Positions end = interpolate(*time, *previous_, current_);
            if (start_) add_vector(*start_, end);
            start_ = std::move(end);
        }
        std::swap(*previous_, current_);
    } else {
        previous_ = std::move(current_);
        current_ = {};
    }
}

void DisplacementSpectrum::add_vector(const Positions& start, const Positions& end) {
    const std::size_t cells = spectrum_->cells();
    const double length = static_cast<double>(cells) * diameter_;
    const double cell_height = std::numbers::sqrt3 / 2 * diameter_;
    const double bottom = plate_state(*plates_.bottom, start.time).height;
    int top = 0;
    for (const LayerGroup& group : options_.groups)
        top = std::max(top, group.last);
    std::vector<std::vector<double>> layers(static_cast<std::size_t>(top) + 1,
                                            std::vector<double>(cells, 0.0));
    for (std::size_t i = 0; i < start.x.size(); ++i) {
        const double layer = std::floor((start.y[i] - bottom) / cell_height) + 1;
        if (layer < 1 || layer > top) continue;
        const double centred = start.x[i] + diameter_ / 2;
        const double wrapped = centred - length * std::floor(centred / length);
        const auto cell = std::min(static_cast<std::size_t>(wrapped / diameter_), cells - 1);
        layers[static_cast<std::size_t>(layer)][cell] += end.x[i] - start.x[i];
    }
    for (std::size_t g = 0; g < options_.groups.size(); ++g) {
        const LayerGroup& group = options_.groups[g];
        std::vector<std::vector<double>> spectra;
        for (int y = group.first; y <= group.last; ++y) {
            spectra.push_back((*spectrum_)(layers[static_cast<std::size_t>(y)]));
        }
        group_spectra_[g].push_back(mean_spectrum(spectra));
    }
    keep_field(start, end);
}

void DisplacementSpectrum::keep_field(const Positions& start, const Positions& end) {
    const double length = static_cast<double>(spectrum_->cells()) * diameter_;
    const double bottom = plate_state(*plates_.bottom, start.time).height;
    field_.assign(4, std::vector<double>(start.x.size()));
    for (std::size_t i = 0; i < start.x.size(); ++i) {
        field_[0][i] = start.x[i] - length * std::floor(start.x[i] / length);
        field_[1][i] = start.y[i] - bottom;
        field_[2][i] = end.x[i] - start.x[i];
        field_[3][i] = end.y[i] - start.y[i];
    }
}

std::string DisplacementSpectrum::named(const std::string& name, char joint) const {
    switch (options_.crossing) {
    case Crossing::upward:
        break;
    case Crossing::downward:
        return name + joint + "downward";
    case Crossing::either:
        return name + joint + "either";
    }
    return name;
}

void DisplacementSpectrum::add_slope(std::size_t group, FitWindow window, const std::string& name,
                                     bool with_systematic, Results& results) const {
    const auto& spectra = group_spectra_[group];
    const auto slope = slope_of_mean(spectra, window.k_min, window.k_max);
    if (!slope) return;
    Measurement measurement{.observable = named(name),
                            .value = slope->value,
                            .standard_error = slope->standard_error,
                            .n = spectra.size(),
                            .settings = {{"k_min", window.k_min},
                                         {"k_max", window.k_max},
                                         {"vectors", static_cast<double>(spectra.size())}}};
    if (slope->standard_error_blocks_of_two > 0) {
        measurement.settings["stderr_blocks_of_two"] = slope->standard_error_blocks_of_two;
    }
    if (with_systematic) {
        double least = slope->value, most = slope->value;
        for (const int k_max : {8, 16, 32}) {
            const auto other = log_log_slope(mean_spectrum(spectra), 1, k_max);
            if (!other) continue;
            least = std::min(least, *other);
            most = std::max(most, *other);
        }
        measurement.systematic = (most - least) / 2;
    }
    results.measurements.push_back(std::move(measurement));
}

void DisplacementSpectrum::add_series(Results& results) const {
    Series series{.name = named("spectrum", '-'), .columns = {"K"}, .values = {{}}};
    const std::size_t highest = spectrum_->cells() / 2;
    for (std::size_t k = 1; k <= highest; ++k) {
        series.values[0].push_back(static_cast<double>(k));
    }
    for (std::size_t g = 0; g < options_.groups.size(); ++g) {
        const auto& spectra = group_spectra_[g];
        std::vector<double> mean, error, at_k(spectra.size());
        for (std::size_t k = 1; k <= highest; ++k) {
            std::ranges::transform(spectra, at_k.begin(), [k](const auto& s) { return s[k]; });
            // The jackknife of a mean is its ordinary standard error.
            const numerics::MeanWithError power = numerics::mean_with_error(at_k);
            mean.push_back(power.value);
            error.push_back(power.standard_error);
        }
        const std::string group = label(options_.groups[g]);
        series.columns.insert(series.columns.end(), {"S_" + group, "err_" + group});
        series.values.push_back(std::move(mean));
        series.values.push_back(std::move(error));
    }
    results.series.push_back(std::move(series));
}

void DisplacementSpectrum::add_fits(Results& results) const {
    Series fits{.name = named("spectrum-fit", '-'),
                .columns = {"layer_first", "layer_last", "k_min", "k_max", "exponent",
                            "exponent_err", "amplitude"},
                .values = std::vector<std::vector<double>>(7)};
    for (std::size_t g = 0; g < options_.groups.size(); ++g) {
        const auto& spectra = group_spectra_[g];
        const auto slope = slope_of_mean(spectra, options_.k_min, options_.k_max);
        const auto law = fit_power_law(mean_spectrum(spectra), options_.k_min, options_.k_max);
        if (!slope || !law) continue;
        const std::array<double, 7> row{static_cast<double>(options_.groups[g].first),
                                        static_cast<double>(options_.groups[g].last),
                                        static_cast<double>(options_.k_min),
                                        static_cast<double>(options_.k_max),
                                        law->exponent,
                                        slope->standard_error,
                                        law->amplitude};
        for (std::size_t c = 0; c < row.size(); ++c)
            fits.values[c].push_back(row[c]);
    }
    if (!fits.values[0].empty()) results.series.push_back(std::move(fits));
}

void DisplacementSpectrum::finish(Results& results) {
    if (!spectrum_ || group_spectra_.front().empty()) return;
    const std::size_t vectors = group_spectra_.front().size();
    results.measurements.push_back({.observable = named("displacement_vectors"),
                                    .value = static_cast<double>(vectors),
                                    .n = vectors,
                                    .settings = {}});
    constexpr std::size_t fewest_vectors = 3;
    if (vectors < fewest_vectors) return;
    for (std::size_t g = 0; g < options_.groups.size(); ++g) {
        const std::string group = label(options_.groups[g]);
        add_slope(g, {options_.k_min, options_.k_max}, "slope_" + group, true, results);
        add_slope(g, {1, 8}, "slope_" + group + "_K1_8", false, results);
        add_slope(g, {1, 32}, "slope_" + group + "_K1_32", false, results);
        add_slope(g, {options_.tail_min, options_.tail_max}, "slope_tail_" + group, false, results);
    }
    add_series(results);
    add_fits(results);
    results.series.push_back({.name = named("displacement-field", '-'),
                              .columns = {"x", "y", "dx", "dy"},
                              .values = field_,
                              .units = {"l", "l", "l", "l"}});
}

}  // namespace crossgrain::measure
