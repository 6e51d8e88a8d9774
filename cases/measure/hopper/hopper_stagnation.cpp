#include "cases/measure/hopper/hopper_stagnation.hpp"

#include "cases/measure/hopper/hopper_lattice.hpp"
#include "cases/measure/hopper/hopper_power_fit.hpp"
#include "cases/measure/hopper/hopper_replicas.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace crossgrain::measure {
namespace {

/// Up to here the paper finds mass flow ("about 13 degrees in our computations").
constexpr double mass_flow_up_to = 12;

/// Half the range of angles (degrees) that make a profile together.
constexpr double profile_within = 0.5;

bool is_frame(const scene::HopperAutomaton& scene, std::int64_t iteration) {
    return iteration > 0 && iteration <= scene.iterations &&
           (iteration == scene.iterations || iteration % scene.every == 0);
}

}  // namespace

HopperStagnation::HopperStagnation(const scene::HopperAutomaton& scene,
                                   HopperStagnationOptions options)
    : scene_(scene), at_(std::move(options.at)), profile_at_(options.profile_at) {
    if (at_.empty()) at_.push_back(scene.iterations);
    for (const std::int64_t iteration : at_) {
        if (is_frame(scene, iteration)) continue;
        throw std::invalid_argument(
            fmt::format("iteration {} is no frame: these come every {} up to {}", iteration,
                        scene.every, scene.iterations));
    }
    const bool has_angle = std::ranges::any_of(scene.angles, [&](double angle) {
        return std::abs(angle - profile_at_.value_or(angle)) <= profile_within;
    });
    if (!has_angle) {
        throw std::invalid_argument(fmt::format("no angle within {:g} degrees of profile_at = {:g}",
                                                profile_within, profile_at_.value_or(0)));
    }
}

void HopperStagnation::add(const scene::HopperFrame& frame) {
    if (frame.iteration == 0) return;
    auto& walls = walls_[frame.iteration];
    const auto replicas = static_cast<std::size_t>(scene_.replicas);
    walls.resize(scene_.angles.size() * replicas);
    const auto share = [&](std::int32_t reach) {
        return static_cast<double>(reach + 1) / static_cast<double>(scene_.levels);
    };
    walls.at(frame.angle_index * replicas + static_cast<std::size_t>(frame.replica)) = {
        share(frame.left_reach), share(frame.right_reach)};
    ++seen_[frame.iteration];
}

bool HopperStagnation::complete(std::int64_t iteration) const {
    const auto found = seen_.find(iteration);
    return found != seen_.end() &&
           found->second == scene_.angles.size() * static_cast<std::size_t>(scene_.replicas);
}

std::vector<AngleSweep> HopperStagnation::sweeps(std::int64_t iteration) const {
    const auto& walls = walls_.at(iteration);
    const auto replicas = static_cast<std::size_t>(scene_.replicas);
    std::vector<AngleSweep> result(replicas, AngleSweep{.angles = scene_.angles});
    for (std::size_t a = 0; a < scene_.angles.size(); ++a) {
        for (std::size_t r = 0; r < replicas; ++r)
            result[r].p.push_back(walls[a * replicas + r].mean());
    }
    return result;
}

void HopperStagnation::append_moving_fraction(std::int64_t iteration, const std::string& suffix,
                                              Results& results) const {
    std::vector<double> left, right, both;
    const bool one_angle = scene_.angles.size() == 1;
    const auto counts = [&](double angle) {
        return one_angle ? angle <= widest_meaningful_angle : angle <= mass_flow_up_to + 1e-9;
    };
    const auto replicas = static_cast<std::size_t>(scene_.replicas);
    for (std::size_t r = 0; r < replicas; ++r) {
        Walls sum;
        double angles = 0;
        for (std::size_t a = 0; a < scene_.angles.size(); ++a) {
            if (!counts(scene_.angles[a])) continue;
            const Walls& walls = walls_.at(iteration)[a * replicas + r];
            sum.left += walls.left;
            sum.right += walls.right;
            ++angles;
        }
        if (angles == 0) return;
        left.push_back(sum.left / angles);
        right.push_back(sum.right / angles);
        both.push_back(sum.mean() / angles);
    }
    append_replica_mean(results, "moving_fraction" + suffix, both);
    append_replica_mean(results, "moving_fraction_left" + suffix, left);
    append_replica_mean(results, "moving_fraction_right" + suffix, right);
}

void HopperStagnation::append_exponents(std::int64_t iteration, const std::string& suffix,
                                        Results& results) const {
    const std::vector<AngleSweep> replicas = sweeps(iteration);
    for (const StagnationLaw& law : stagnation_laws()) {
        const auto estimate = over_replicas(replicas, scene_.seed,
                                            [&](const AngleSweep& sweep) -> std::optional<double> {
                                                const auto fit = fit_stagnation(law, sweep);
                                                if (!fit) return std::nullopt;
                                                return fit->exponent;
                                            });
        if (!estimate) continue;
        results.measurements.push_back(
            {.observable = "exponent_" + law.name() + suffix,
             .value = estimate->value,
             .standard_error = estimate->standard_error,
             .n = estimate->n,
             .settings = {{"from_degrees", law.from},
                          {"to_degrees", law.to},
                          {"iteration", static_cast<double>(iteration)}}});
    }
}

void HopperStagnation::append_critical_angles(std::int64_t iteration, const std::string& suffix,
                                              Results& results) const {
    constexpr double threshold = 0.99, low = 0.98, high = 0.998;
    const std::vector<AngleSweep> replicas = sweeps(iteration);
    const auto at = [&](double p) {
        return of_replica_mean(replicas, scene_.seed,
                               [p](const AngleSweep& sweep) { return end_of_mass_flow(sweep, p); });
    };
    const auto value = at(threshold), lenient = at(low), strict = at(high);
    if (value && lenient && strict) {
        results.measurements.push_back(
            {.observable = "critical_angle" + suffix,
             .value = value->value,
             .standard_error = value->standard_error,
             .systematic = std::abs(lenient->value - strict->value) / 2,
             .n = value->n,
             .unit = "degrees",
             .settings = {{"threshold", threshold},
                          {"iteration", static_cast<double>(iteration)}}});
    }
    const StagnationLaw law{.fit = StagnationFit::log, .from = 20, .to = 90};
    const auto where_fit_is_one = [&](const AngleSweep& sweep) -> std::optional<double> {
        const auto fit = fit_stagnation(law, sweep);
        if (!fit) return std::nullopt;
        return std::pow(fit->amplitude, -1 / fit->exponent);
    };
    if (const auto crossing = over_replicas(replicas, scene_.seed, where_fit_is_one)) {
        results.measurements.push_back(
            {.observable = "critical_angle_fit" + suffix,
             .value = crossing->value,
             .standard_error = crossing->standard_error,
             .n = crossing->n,
             .unit = "degrees",
             .settings = {{"iteration", static_cast<double>(iteration)}}});
    }
}

void HopperStagnation::append_at(std::int64_t iteration, Results& results) const {
    const std::string suffix = iteration == at_.front() ? "" : fmt::format("_at_{}", iteration);
    append_moving_fraction(iteration, suffix, results);
    append_exponents(iteration, suffix, results);
    append_critical_angles(iteration, suffix, results);
}

void HopperStagnation::append_series(Results& results) const {
    Series series{.name = "stagnation",
                  .columns = {"theta", "iteration", "left", "right", "P", "standard_error"},
                  .values = std::vector<std::vector<double>>(6),
                  .units = {"degrees", "iterations", "1", "1", "1", "1"}};
    const auto replicas = static_cast<std::size_t>(scene_.replicas);
    for (const auto& [iteration, walls] : walls_) {
        if (!complete(iteration)) continue;
        for (std::size_t a = 0; a < scene_.angles.size(); ++a) {
            std::vector<double> p;
            Walls sum;
            for (std::size_t r = 0; r < replicas; ++r) {
                const Walls& one = walls[a * replicas + r];
                p.push_back(one.mean());
                sum.left += one.left / static_cast<double>(replicas);
                sum.right += one.right / static_cast<double>(replicas);
            }
            const numerics::MeanWithError mean = numerics::mean_with_error(p);
            const std::array row{scene_.angles[a], static_cast<double>(iteration),
                                 sum.left,         sum.right,
                                 mean.value,       mean.standard_error};
            for (std::size_t i = 0; i < row.size(); ++i)
                series.values[i].push_back(row[i]);
        }
    }
    results.series.push_back(std::move(series));
}

void HopperStagnation::append_fits(Results& results) const {
    const AngleSweep sweep = mean_sweep(sweeps(at_.front()));
    const auto unweighted = fit_stagnation({StagnationFit::unweighted, 13, 90}, sweep);
    const auto log = fit_stagnation({StagnationFit::log, 13, 90}, sweep);
    if (!unweighted || !log) return;
    Series series{.name = "stagnation-fits",
                  .columns = {"theta", "1/P", "unweighted fit", "log fit", "experiment 2.1",
                              "experiment 2.3"},
                  .values = std::vector<std::vector<double>>(6),
                  .units = {"degrees", "1", "1", "1", "1", "1"}};
    const double middle = std::sqrt(13.0 * 90.0);
    const double anchor = log->amplitude * std::pow(middle, log->exponent);
    for (std::size_t a = 0; a < sweep.p.size(); ++a) {
        const double theta = scene_.angles[a];
        const std::array row{theta,
                             1 / sweep.p[a],
                             unweighted->amplitude * std::pow(theta, unweighted->exponent),
                             log->amplitude * std::pow(theta, log->exponent),
                             anchor * std::pow(theta / middle, 2.1),
                             anchor * std::pow(theta / middle, 2.3)};
        for (std::size_t i = 0; i < row.size(); ++i)
            series.values[i].push_back(row[i]);
    }
    results.series.push_back(std::move(series));
}

void HopperStagnation::append_profile(double angle, Results& results) const {
    std::vector<double> reached;  // by wall, in units of the wall
    const auto& walls = walls_.at(at_.front());
    const auto replicas = static_cast<std::size_t>(scene_.replicas);
    for (std::size_t a = 0; a < scene_.angles.size(); ++a) {
        if (std::abs(scene_.angles[a] - angle) > profile_within) continue;
        for (std::size_t r = 0; r < replicas; ++r) {
            reached.push_back(walls[a * replicas + r].left);
            reached.push_back(walls[a * replicas + r].right);
        }
    }
    Series series{.name = "wall-profile",
                  .columns = {"height", "moved", "standard_error"},
                  .values = std::vector<std::vector<double>>(3),
                  .units = {"1", "1", "1"}};
    constexpr int heights = 100;
    const auto count = static_cast<double>(reached.size());
    for (int h = 1; h <= heights; ++h) {
        const double height = static_cast<double>(h) / heights;
        const auto beyond =
            std::ranges::count_if(reached, [&](double reach) { return reach >= height; });
        const double moved = static_cast<double>(beyond) / count;
        series.values[0].push_back(height);
        series.values[1].push_back(moved);
        series.values[2].push_back(std::sqrt(moved * (1 - moved) / count));
    }
    results.series.push_back(std::move(series));
}

void HopperStagnation::finish(Results& results) {
    const double widest = std::ranges::max(scene_.angles);
    if (widest > widest_meaningful_angle) {
        results.findings.push_back(
            {.name = "state",
             .label = "no meaning",
             .detail = fmt::format("at {:g} degrees the walls are flatter than the 30 degrees "
                                   "along which grains move: what lies on them stays, and P has "
                                   "no meaning",
                                   widest)});
    }
    if (!complete(at_.front())) return;
    append_series(results);
    append_fits(results);
    if (profile_at_) append_profile(*profile_at_, results);
    for (const std::int64_t iteration : at_) {
        if (complete(iteration)) append_at(iteration, results);
    }
}

}  // namespace crossgrain::measure
