#include "cases/measure/hopper/hopper_pattern.hpp"

#include "cases/measure/hopper/hopper_lattice.hpp"
#include "cases/measure/hopper/hopper_replicas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

/// Below this correlation there is no pattern: random orientations give 0 +- 0.01 in the box.
constexpr double least_correlation = 0.1;
/// Above this asymmetry a hopper empties on one side: symmetric ones have 0.01 to 0.05.
constexpr double most_asymmetry = 0.2;

double imbalance(double one, double other) {
    return one + other == 0 ? 0 : (one - other) / (one + other);
}

/// Of the emptied sites to the left and to the right of the middle.
double emptied_imbalance(const scene::HopperFrame& frame) {
    double left = 0, right = 0;
    for (const scene::HopperLevel& level : frame.levels) {
        for (std::size_t i = 0; i < level.sites(); ++i) {
            if (frame.state[level.offset + i] != 0) continue;
            const std::int64_t column = level.first + 2 * static_cast<std::int64_t>(i);
            if (column < 0) ++left;
            if (column > 0) ++right;
        }
    }
    return imbalance(left, right);
}

double slant_imbalance(const scene::HopperFrame& frame) {
    const auto grains = [&](std::uint8_t orientation) {
        return static_cast<double>(std::ranges::count(frame.state, orientation));
    };
    return imbalance(grains(1), grains(3));
}

void append_curve(Results& results, const std::vector<PatternShape>& shapes, const char* name,
                  double step, std::vector<double> PatternShape::*curve) {
    std::size_t length = (shapes.front().*curve).size();
    for (const PatternShape& shape : shapes)
        length = std::min(length, (shape.*curve).size());
    Series series{.name = name,
                  .columns = {"separation", "G"},
                  .values = std::vector<std::vector<double>>(2),
                  .units = {"spacings", "1"}};
    for (std::size_t i = 0; i < length; ++i) {
        double sum = 0;
        for (const PatternShape& shape : shapes)
            sum += (shape.*curve)[i];
        series.values[0].push_back(static_cast<double>(i) * step);
        series.values[1].push_back(sum / static_cast<double>(shapes.size()));
    }
    results.series.push_back(std::move(series));
}

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

}  // namespace

HopperPattern::HopperPattern(const scene::HopperAutomaton& scene, HopperPatternOptions options)
    : options_(options), scene_(scene) {
    if (scene.angles.size() != 1) throw std::invalid_argument("the scene has more than one angle");
    check_ranges(options);
    if (!(options.to > options.from && options.from < (scene.levels - 1) * level_spacing)) {
        throw std::invalid_argument("the box is empty or above the hopper");
    }
    if (options.lag % scene.every != 0 || options.lag > scene.iterations) {
        throw std::invalid_argument(
            fmt::format("'lag' = {} is no multiple of the {} iterations between frames",
                        options.lag, scene.every));
    }
}

void HopperPattern::add(const scene::HopperFrame& frame) {
    // A last frame off the schedule would have another distance from the one before.
    const bool on_schedule = frame.iteration % scene_.every == 0;
    const std::int64_t begin = scene_.iterations - options_.window - options_.lag;
    if (frame.iteration < begin && !frame.last) return;
    OrientationBox box(frame, {options_.half_width, options_.from, options_.to});
    Replica& replica = running_[frame.replica];
    if (frame.last) {
        Outcome outcome{.shape = pattern_shape(box),
                        .vertical_fraction = box.vertical_fraction(),
                        .emptied_imbalance = emptied_imbalance(frame),
                        .slant_imbalance = slant_imbalance(frame)};
        outcomes_.push_back(std::move(outcome));
    }
    if (on_schedule) {
        const auto kept = static_cast<std::size_t>(options_.lag / scene_.every);
        if (replica.past.size() == kept) {
            replica.counts.add(replica.past.front(), box);
            replica.past.pop_front();
        }
        replica.past.push_back(std::move(box));
    }
    if (frame.last) {
        outcomes_.back().shift = pattern_shift(replica.counts);
        running_.erase(frame.replica);
    }
}

std::vector<PatternShape> HopperPattern::shapes() const {
    std::vector<PatternShape> result;
    for (const Outcome& outcome : outcomes_) {
        if (outcome.shape) result.push_back(*outcome.shape);
    }
    return result;
}

bool HopperPattern::has_pattern() const {
    return !shapes().empty() && std::ranges::all_of(outcomes_, [](const Outcome& outcome) {
        if (!outcome.shape) return true;
        return outcome.shape->neighbour >= least_correlation && outcome.shift.all &&
               outcome.shift.all->height >= least_correlation;
    });
}

void HopperPattern::append_velocities(Results& results) const {
    if (!has_pattern()) return;
    const std::map<std::string, double> settings{{"lag", static_cast<double>(options_.lag)},
                                                 {"window", static_cast<double>(options_.window)}};
    const auto append = [&](const std::string& which,
                            std::optional<CorrelationPeak> PatternShift::*of) {
        std::vector<double> velocities;
        std::size_t rising = 0, uniform = 0;
        for (const Outcome& outcome : outcomes_) {
            if (!outcome.shape) ++uniform;
            const auto& peak = outcome.shift.*of;
            if (!outcome.shape || !peak || peak->height < least_correlation) continue;
            velocities.push_back(peak->shift / static_cast<double>(options_.lag));
            rising += peak->shift > 0 ? 1U : 0U;
        }
        if (velocities.size() + uniform < outcomes_.size()) return;
        append_replica_mean(results, "pattern_velocity" + which, velocities,
                            "spacings per iteration", settings);
        append_share(results, "rising_share" + which, rising, velocities.size(), settings);
    };
    append("", &PatternShift::all);
    append("_vertical", &PatternShift::vertical);
    append("_slanted", &PatternShift::slanted);
}

void HopperPattern::append_shapes(Results& results) const {
    const std::vector<PatternShape> all = shapes();
    if (all.empty()) return;
    std::vector<double> neighbour, x, y;
    double bounded_x = 0, bounded_y = 0;
    std::size_t horizontal = 0;
    for (const PatternShape& shape : all) {
        neighbour.push_back(shape.neighbour);
        x.push_back(shape.length_x);
        y.push_back(shape.length_y);
        bounded_x += shape.bounded_x ? 1 : 0;
        bounded_y += shape.bounded_y ? 1 : 0;
        horizontal += shape.length_x > shape.length_y ? 1U : 0U;
    }
    const double uniform = static_cast<double>(outcomes_.size() - all.size());
    append_replica_mean(results, "neighbour_correlation", neighbour, "1", {{"uniform", uniform}});
    append_replica_mean(results, "correlation_length_x", x, "spacings",
                        {{"bounded", bounded_x}, {"uniform", uniform}});
    append_replica_mean(results, "correlation_length_y", y, "spacings",
                        {{"bounded", bounded_y}, {"uniform", uniform}});
    append_share(results, "horizontal_share", horizontal, all.size(), {{"uniform", uniform}});
    append_curve(results, all, "orientation-correlation-x", 2 * column_spacing,
                 &PatternShape::along_x);
    append_curve(results, all, "orientation-correlation-y", 2 * level_spacing,
                 &PatternShape::along_y);
}

void HopperPattern::append_state(Results& results) const {
    if (scene_.angles.front() > widest_meaningful_angle) return;
    std::vector<double> asymmetry, neighbour, x, y;
    for (const Outcome& outcome : outcomes_)
        asymmetry.push_back(std::abs(outcome.emptied_imbalance));
    for (const PatternShape& shape : shapes()) {
        neighbour.push_back(shape.neighbour);
        x.push_back(shape.length_x);
        y.push_back(shape.length_y);
    }
    const double s = mean_of(asymmetry);
    Finding finding{.name = "state",
                    .detail = fmt::format("asymmetry {:.3f} (limit {:g})", s, most_asymmetry)};
    if (neighbour.empty()) {
        finding.label = "patches";
        finding.detail += ", one orientation fills the box";
    } else {
        const double g = mean_of(neighbour), lx = mean_of(x), ly = mean_of(y);
        finding.label = g < least_correlation ? "structureless" : lx > ly ? "bands" : "patches";
        finding.detail += fmt::format(", neighbour correlation {:.3f} (limit {:g}), lengths "
                                      "{:.3g} across and {:.3g} along gravity",
                                      g, least_correlation, lx, ly);
    }
    if (s > most_asymmetry) finding.label = "asymmetric";
    results.findings.push_back(std::move(finding));
}

void HopperPattern::finish(Results& results) {
    if (outcomes_.empty() || outcomes_.size() < static_cast<std::size_t>(scene_.replicas)) return;
    std::vector<double> asymmetry, emptied, slanted, vertical;
    for (const Outcome& outcome : outcomes_) {
        asymmetry.push_back(std::abs(outcome.emptied_imbalance));
        emptied.push_back(outcome.emptied_imbalance);
        slanted.push_back(outcome.slant_imbalance);
        if (outcome.vertical_fraction) vertical.push_back(*outcome.vertical_fraction);
    }
    append_replica_mean(results, "asymmetry", asymmetry);
    append_replica_mean(results, "mirror_imbalance_sites", emptied);
    append_replica_mean(results, "mirror_imbalance_grains", slanted);
    if (vertical.size() == outcomes_.size()) {
        append_replica_mean(results, "vertical_fraction", vertical);
    }
    if (vertical.empty()) return;  // an empty box has no pattern
    append_shapes(results);
    append_velocities(results);
    append_state(results);
}

}  // namespace crossgrain::measure
