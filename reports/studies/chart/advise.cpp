#include "reports/studies/chart/advise.hpp"

#include "reference/compare/equivalence.hpp"
#include "reference/compare/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain::studies {
namespace {

constexpr double two_sided_95 = 1.959964;

Choice choice_of(const ChartPoint& point, std::int64_t runs) {
    return {point, runs, static_cast<double>(runs) * (point.cpu_s + point.start_s)};
}

/// The variant with all physics of which `point` is a copy that leaves something out: the same
/// parameters in the same code.
const ChartPoint* full_variant(const ChartedObservable& charted, const ChartPoint& point) {
    for (const auto& other : charted.points) {
        if (other.drops.empty() && other.code == point.code && other.parameters == point.parameters)
            return &other;
    }
    return nullptr;
}

DroppedPhysics compare_dropped(const ChartPoint& full, const ChartPoint& point, double tolerance) {
    DroppedPhysics result{.drops = point.drops,
                          .variant = point.variant,
                          .difference = point.value - full.value,
                          .cost_ratio = (point.cpu_s + point.start_s) /
                                        std::max(full.cpu_s + full.start_s, 1e-12)};
    const auto standard_error = [](const ChartPoint& p) {
        return p.scatter / std::sqrt(static_cast<double>(p.runs));
    };
    const auto answer = compare::equivalence(
        {.difference = result.difference,
         .standard_error = std::hypot(standard_error(full), standard_error(point)),
         .degrees_of_freedom = static_cast<double>(full.runs + point.runs) - 2,
         .margin = tolerance});
    result.half_width = answer.half_width_95;
    result.verdict = compare::to_string(answer.outcome);
    return result;
}

}  // namespace

std::optional<std::int64_t> runs_needed(const ChartPoint& point, double tolerance) {
    const double room = (tolerance - std::abs(point.bias)) / two_sided_95;
    const double variance = room * room - point.bias_stderr * point.bias_stderr;
    if (room <= 0 || variance <= 0) return std::nullopt;
    const double runs = std::ceil(point.scatter * point.scatter / variance);
    if (!(runs < 1e9)) return std::nullopt;
    return std::max<std::int64_t>(static_cast<std::int64_t>(runs), 1);
}

Advice advise(const ChartedObservable& charted, double tolerance) {
    Advice advice{.observable = charted.observable, .tolerance = tolerance};
    for (const auto& point : charted.points) {
        if (!point.drops.empty()) continue;
        const auto runs = runs_needed(point, tolerance);
        if (!runs) continue;
        const Choice choice = choice_of(point, *runs);
        if (!advice.cheapest || choice.cpu_s < advice.cheapest->cpu_s) advice.cheapest = choice;
    }
    for (const auto& point : charted.points) {
        const double cost = point.cpu_s + point.start_s;
        const bool cheaper = !advice.cheapest || cost < advice.cheapest->cpu_s;
        if (!point.drops.empty() || !cheaper || runs_needed(point, tolerance)) continue;
        if (advice.next_cheaper && advice.next_cheaper->cpu_s > cost) continue;
        const bool wrong = std::abs(point.bias) - two_sided_95 * point.bias_stderr > tolerance;
        advice.next_cheaper = Rejected{point, cost, wrong};
    }
    for (const auto& point : charted.points) {
        if (point.drops.empty()) continue;
        if (const auto* full = full_variant(charted, point)) {
            advice.dropped.push_back(compare_dropped(*full, point, tolerance));
        }
    }
    if (!advice.cheapest) {
        advice.reason = charted.problem.empty()
                            ? fmt::format("none of the {} charted ways is known to be within {:g}; "
                                          "the reference itself is known to {:.2g}",
                                          charted.points.size(), tolerance,
                                          two_sided_95 * charted.reference_stderr)
                            : charted.problem;
    }
    return advice;
}

}  // namespace crossgrain::studies
