// The rules by which two operands are judged, but for convergence in the time step.
#include "reference/compare/equivalence_power.hpp"
#include "reference/compare/trend.hpp"
#include "reference/judge/question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

/// Round-off that has grown to this length has gone through so many collisions that two programs
/// that order their sums differently cannot be alike to the last bit.
constexpr double grown = 1e-9;

/// LIGGGHTS is a fork of LAMMPS: in a gas the same arithmetic in the same order gives the same bits
/// for good (measured: after 100 contact times still no difference at all). A free lid they do not
/// move alike: the one has its own fix for the plate, the other a formula for the force on each
/// grain and its sum, and their round-off grows apart like that of any other two.
bool share_arithmetic(const Question& q) {
    const auto is_pair = [&](const char* one, const char* other) {
        return q.verdict.code == one && q.other == other;
    };
    if (!is_pair("lammps", "liggghts") && !is_pair("liggghts", "lammps")) return false;
    return !q.runs.the_case().grain_scene(q.variants.front(), 0, 1).has_free_lid();
}

compare::Trend trend_of(catalog::Aspect aspect) {
    if (aspect == catalog::Aspect::constant) return compare::Trend::constant;
    return aspect == catalog::Aspect::increasing ? compare::Trend::increasing
                                                 : compare::Trend::decreasing;
}

}  // namespace

void judge_difference(Question& q, const compare::EquivalenceQuestion& difference,
                      std::size_t replicas) {
    const auto answer = compare::equivalence(difference);
    q.verdict.difference = difference.difference;
    q.verdict.uncertainty = answer.half_width_95;
    q.verdict.standard_error = difference.standard_error;
    compare::state_evidence(difference, replicas, q.verdict);
    set_outcome(q, answer.outcome, answer.reason);
}

void judge_equivalence(Question& q, std::span<const Point> points) {
    const auto error_of = [](const Point& point) {
        return std::abs(point.measured.measurement.value - point.reference.value);
    };
    const Point* worst = &points.front();
    for (const Point& point : points) {
        if (!(error_of(point) <= error_of(*worst))) worst = &point;
    }
    const auto measured = operand_of(worst->measured);
    const auto against = q.verdict.against.kind;
    if (against == compare::Against::Kind::closed_form ||
        against == compare::Against::Kind::published) {
        q.verdict.reference = worst->reference.value;
        q.verdict.reference_error = worst->reference.standard_error;
    }
    judge_difference(q, compare::question_of(measured, worst->reference, q.verdict.limit),
                     worst->replicas);
    if (!q.other.empty() && measured.standard_error > 0 &&
        measured.standard_error == worst->reference.standard_error && q.verdict.difference == 0) {
        set_outcome(q, Outcome::disagree,
                    "value and error are the same to the last bit: do both codes read the same "
                    "output?");
    }
}

void judge_parity(Question& q, std::span<const Point> points) {
    q.verdict.difference = points.front().measured.measurement.value;
    const bool same = q.verdict.difference <= q.verdict.limit;
    set_outcome(q, same ? Outcome::agree : Outcome::disagree,
                same ? "" : "differs by more than round-off can explain");
}

void doubt_identical(std::vector<Question>& questions) {
    std::map<std::size_t, double> largest;  // by variant
    for (const Question& q : questions) {
        auto& here = largest[q.variants.front()];
        here = std::max(here, q.verdict.difference);  // stays where nothing was compared
    }
    for (Question& q : questions) {
        const double elsewhere = largest[q.variants.front()];
        const bool doubtful =
            q.check.at_contact_times && q.verdict.difference == 0 && elsewhere >= grown;
        if (!doubtful || share_arithmetic(q)) continue;
        set_outcome(q, Outcome::disagree,
                    fmt::format("the same to the last bit, where other codes differ by {:.1g}: do "
                                "both read the same output?",
                                elsewhere));
    }
}

void judge_trend(Question& q, std::span<const Point> points) {
    std::vector<compare::TrendPoint> along;
    for (const Point& point : points) {
        const auto measured = operand_of(point.measured);
        along.push_back({.at = point.at,
                         .value = measured.value,
                         .standard_error = measured.standard_error,
                         .degrees_of_freedom = measured.degrees_of_freedom});
    }
    const auto answer = compare::judge_trend(trend_of(q.check.aspect), along, q.check.limit);
    q.verdict.difference = answer.difference;
    q.verdict.uncertainty = answer.half_width_95;
    set_outcome(q, answer.outcome, answer.reason);
}

}  // namespace crossgrain::judge
