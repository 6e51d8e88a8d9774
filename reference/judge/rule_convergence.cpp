// The rule of convergence: order in the time step, and limit for dt -> 0.
#include "reference/compare/convergence.hpp"
#include "reference/judge/question.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

/// Below this, an error is round-off and has no order in dt.
constexpr double round_off = 1e-12;

compare::Rung rung_of(const Point& point) {
    const auto& m = point.measured.measurement;
    const auto n = static_cast<double>(m.n);
    const double error = m.value - point.reference.value;
    const double scatter = m.standard_error * std::sqrt(std::max(0.0, n - 1));
    const double rms = std::hypot(error, scatter);
    return {.dt = point.at,
            .mean_error = error,
            .mean_standard_error = m.standard_error,
            .rms_error = rms,
            .rms_standard_error = n > 1 ? rms / std::sqrt(2 * n) : 0.0};
}

/// Runs whose time steps differ by less than this are one rung: their time steps differ only to
/// average over the phase at which a contact ends (a contact time that is a whole number of steps
/// makes the error look far too small).
constexpr double same_rung = 1.1;

compare::Rung pool(const std::vector<compare::Rung>& rungs) {
    const auto n = static_cast<double>(rungs.size());
    compare::Rung pooled;
    double mean_variance = 0;
    double mean_square = 0;
    double rms_variance = 0;
    for (const auto& rung : rungs) {
        pooled.dt += rung.dt / n;
        pooled.mean_error += rung.mean_error / n;
        mean_variance += rung.mean_standard_error * rung.mean_standard_error / (n * n);
        mean_square += rung.rms_error * rung.rms_error / n;
        rms_variance += rung.rms_standard_error * rung.rms_standard_error / (n * n);
    }
    pooled.mean_standard_error = std::sqrt(mean_variance);
    pooled.rms_error = std::sqrt(mean_square);
    pooled.rms_standard_error = std::sqrt(rms_variance);
    return pooled;
}

/// Largest time step first.
std::vector<compare::Rung> pooled_rungs(std::span<const Point> points) {
    std::vector<compare::Rung> single;
    std::ranges::transform(points, std::back_inserter(single), rung_of);
    std::sort(single.begin(), single.end(),
              [](const auto& a, const auto& b) { return a.dt > b.dt; });
    std::vector<compare::Rung> pooled;
    std::vector<compare::Rung> group;
    for (const auto& rung : single) {
        if (!group.empty() && group.front().dt > same_rung * rung.dt) {
            pooled.push_back(pool(group));
            group.clear();
        }
        group.push_back(rung);
    }
    pooled.push_back(pool(group));
    return pooled;
}

}  // namespace

void judge_convergence(Question& q, std::span<const Point> points) {
    const bool wants_order = q.check.aspect == catalog::Aspect::order;
    const std::vector<compare::Rung> rungs = pooled_rungs(points);
    ConvergenceCurve curve{
        .code = q.verdict.code, .variant = q.verdict.variant, .observable = q.check.observable};
    bool exact_to_round_off = true;
    for (const auto& rung : rungs) {
        curve.dt.push_back(rung.dt);
        curve.mean_error.push_back(rung.mean_error);
        curve.rms_error.push_back(rung.rms_error);
        exact_to_round_off = exact_to_round_off && rung.rms_error < round_off;
    }
    if (exact_to_round_off) {
        if (!wants_order) return judge_equivalence(q, points);
        return set_outcome(q, Outcome::undecided,
                           "the error is round-off at every dt: it has no order");
    }
    try {
        const compare::Convergence fit = compare::convergence(rungs);
        curve.order = fit.order.value;
        curve.order_error = fit.order.standard_error;
        curve.order_degrees_of_freedom = fit.order.degrees_of_freedom;
        curve.limit = fit.limit.value;
        curve.limit_error = fit.limit.standard_error;
        const compare::Estimate& estimate = wants_order ? fit.order : fit.limit;
        if (!wants_order) q.verdict.reference = points.front().reference.value;
        judge_difference(
            q,
            {.difference = wants_order ? estimate.value - q.check.order : estimate.value,
             .standard_error = estimate.standard_error,
             .degrees_of_freedom = estimate.degrees_of_freedom,
             .margin = q.check.limit},
            points.front().replicas);
        if (wants_order) q.curve = std::move(curve);
    } catch (const std::invalid_argument& error) {
        set_outcome(q, Outcome::undecided, error.what());
    }
}

}  // namespace crossgrain::judge
