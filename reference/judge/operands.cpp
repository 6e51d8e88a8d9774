// What a check compares: measurements of codes, closed forms, numbers and trends of the literature.
#include "reference/compare/parity.hpp"
#include "reference/judge/question.hpp"
#include "reference/oracles/oracles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

Operands missing(Outcome outcome, std::string reason) {
    return {.points = {},
            .missing = Absence{.outcome = outcome, .reason = std::move(reason), .code = {}}};
}

Operands not_measured(const std::string& observable, const std::string& by = "") {
    return missing(Outcome::undecided, fmt::format("'{}' was not measured{}", observable, by));
}

/// Why a code has no result to be judged. A fit leaves out the variants that were not run or cannot
/// be expressed, but not one whose run failed.
std::optional<Absence> absence_of(const Question& q, const std::string& code, std::size_t variant) {
    if (!is_fitted(q.runs.the_case(), q.check.observable)) return q.runs.absence(code, variant);
    std::optional<Absence> first;
    bool any_run = false;
    for (std::size_t v = 0; v < q.runs.the_case().variants.size(); ++v) {
        const auto here = q.runs.absence(code, v);
        if (here && here->outcome == Outcome::run_failed) return here;
        if (!here) any_run = true;
        if (!first) first = here;
    }
    return any_run ? std::nullopt : first;
}

/// The first absence of a code in a variant.
std::optional<Absence> absence(const Question& q) {
    for (const auto& code : {q.verdict.code, q.other}) {
        if (code.empty()) continue;
        for (const std::size_t variant : q.variants) {
            auto absent = absence_of(q, code, variant);
            if (absent && !q.other.empty()) {
                absent->reason = fmt::format("{}: {}", code, absent->reason);
                absent->code = code;
            }
            if (absent) return absent;
        }
    }
    return std::nullopt;
}

/// Of two codes, of one code in two variants, or two observables of one code.
Operands two_measurements(const Question& q) {
    const auto read = [&](const std::string& code, std::size_t variant, const std::string& name) {
        // A fit has the same value in both variants and would agree with itself.
        if (!q.check.between.empty()) return q.runs.combined(code, variant, 0, name);
        return measured(q.runs, q.evaluation, code, variant, name);
    };
    const std::string& second = q.check.with.empty() ? q.check.observable : q.check.with;
    const auto a = read(q.verdict.code, q.variants.front(), q.check.observable);
    const auto b = read(q.other.empty() ? q.verdict.code : q.other, q.variants.back(), second);
    if (!a || !b) {
        return not_measured(a ? second : q.check.observable, q.other.empty() ? "" : " by both");
    }
    return {.points = {{.measured = *a,
                        .reference = operand_of(*b),
                        .replicas = std::min(a->replicas, b->replicas)}},
            .missing = {}};
}

/// Every time step of the ladder, and the closed form there.
Operands ladder(const Question& q) {
    const auto& the_case = q.runs.the_case();
    const std::size_t variant = q.variants.front();
    const std::string form = to_string(q.check.against);
    Operands found;
    for (std::size_t rung = 0; rung < the_case.variants[variant].rungs; ++rung) {
        const auto combined = q.runs.combined(q.verdict.code, variant, rung, q.check.observable);
        if (!combined) return not_measured(q.check.observable);
        const auto scene = the_case.scene(variant, rung, 1);
        const auto exact = oracles::exact_value(form, scene);
        if (!exact) {
            return missing(Outcome::no_reference, fmt::format("no '{}' for this scene", form));
        }
        found.points.push_back({.at = scene::time_step_of(scene),
                                .measured = *combined,
                                .reference = {.value = *exact},
                                .replicas = combined->replicas});
    }
    return found;
}

Operands published_value(const Question& q) {
    const std::string& id = q.check.against.name;
    const auto reference = q.literature.find(id);
    if (!reference || !reference->trend.empty()) {  // a trend has no number to compare with
        return missing(Outcome::no_reference, fmt::format("no published value '{}'", id));
    }
    const auto combined =
        measured(q.runs, q.evaluation, q.verdict.code, q.variants.front(), q.check.observable);
    if (!combined) return not_measured(q.check.observable);
    return {
        .points = {{.measured = *combined,
                    .reference = {.value = reference->value, .standard_error = reference->error},
                    .replicas = combined->replicas}},
        .missing = {}};
}

std::string word_of(catalog::Aspect aspect) {
    if (aspect == catalog::Aspect::constant) return "constant";
    return aspect == catalog::Aspect::increasing ? "increasing" : "decreasing";
}

/// Every variant of the sweep. The reason names the variant that lacks something.
Operands sweep(const Question& q) {
    const std::string& id = q.check.against.name;
    const auto reference = q.literature.find(id);
    if (!reference || reference->trend != word_of(q.check.aspect)) {
        return missing(Outcome::no_reference, fmt::format("no published trend '{}' that is {}", id,
                                                          word_of(q.check.aspect)));
    }
    Operands found;
    for (const std::size_t variant : q.variants) {
        const auto& of_case = q.runs.the_case().variants[variant];
        if (const auto absent = q.runs.absence(q.verdict.code, variant)) {
            return missing(absent->outcome, fmt::format("{}: {}", of_case.name, absent->reason));
        }
        const auto combined = q.runs.combined(q.verdict.code, variant, 0, q.check.observable);
        if (!combined) {
            return missing(Outcome::undecided, fmt::format("{}: '{}' was not measured",
                                                           of_case.name, q.check.observable));
        }
        found.points.push_back({.at = std::stod(*of_case.parameter(q.check.along)),
                                .measured = *combined,
                                .replicas = combined->replicas});
    }
    if (found.points.size() < 2) return missing(Outcome::undecided, "one point shows no trend");
    return found;
}

const measure::Measurement* find_measurement(const measure::Results& results,
                                             const std::string& observable) {
    const auto found =
        std::ranges::find(results.measurements, observable, &measure::Measurement::observable);
    return found == results.measurements.end() ? nullptr : &*found;
}

/// Difference of one run of code a and its sibling of code b; nothing if either lacks it.
std::optional<double> run_difference(const catalog::Check& check, double contact_time,
                                     const measure::Results& a, const measure::Results& b) {
    if (check.at_contact_times) {
        const double time = *check.at_contact_times * contact_time;
        const auto* in_a = compare::find_snapshot(a, time);
        const auto* in_b = compare::find_snapshot(b, time);
        if (in_a == nullptr || in_b == nullptr) return std::nullopt;
        return compare::largest_difference(*in_a, *in_b);
    }
    if (!check.column.empty()) {
        const auto* in_a = compare::find_series(a, check.observable);
        const auto* in_b = compare::find_series(b, check.observable);
        if (in_a == nullptr || in_b == nullptr) return std::nullopt;
        compare::Window window;
        if (check.from) window.from = *check.from;
        if (check.to) window.to = *check.to;
        return compare::largest_difference(*in_a, *in_b, check.column, window);
    }
    const auto* in_a = find_measurement(a, check.observable);
    const auto* in_b = find_measurement(b, check.observable);
    if (in_a == nullptr || in_b == nullptr) return std::nullopt;
    return std::abs(in_a->value - in_b->value);
}

/// The largest difference over all time steps and the replicas both codes have; its reference is 0.
Operands distance_of_runs(const Question& q) {
    const auto& the_case = q.runs.the_case();
    const std::size_t variant = q.variants.front();
    const auto& a = q.verdict.code;
    const auto& b = q.other;
    std::optional<double> largest;
    for (std::size_t rung = 0; rung < the_case.variants[variant].rungs; ++rung) {
        const scene::AnyScene scene = the_case.scene(variant, rung, 1);
        const auto* grains = std::get_if<scene::Scene>(&scene);
        const double contact_time = grains == nullptr ? 0 : scene::contact_time(*grains);
        const auto replicas =
            std::min(q.runs.replicas(a, variant, rung), q.runs.replicas(b, variant, rung));
        for (std::int64_t replica = 0; replica < replicas; ++replica) {
            const auto* of_a = q.runs.find(a, variant, rung, replica);
            const auto* of_b = q.runs.find(b, variant, rung, replica);
            const auto difference =
                of_a == nullptr || of_b == nullptr
                    ? std::nullopt
                    : run_difference(q.check, contact_time, of_a->results, of_b->results);
            if (!difference) {
                return missing(Outcome::undecided,
                               "nothing to compare at the same place in both runs");
            }
            largest = std::max(largest.value_or(0), *difference);
        }
    }
    if (!largest) {
        return missing(Outcome::undecided, "nothing to compare at the same place in both runs");
    }
    Point point;
    point.measured.measurement.value = *largest;
    return {.points = {point}, .missing = {}};
}

}  // namespace

Operands operands_of(const Question& question) {
    using Kind = compare::Against::Kind;
    const Kind against = question.verdict.against.kind;
    if (against == Kind::trend) return sweep(question);
    if (auto absent = absence(question)) return {.points = {}, .missing = std::move(absent)};
    if (against == Kind::closed_form) return ladder(question);
    if (against == Kind::published) return published_value(question);
    const bool parity = question.check.kind == catalog::CheckKind::parity;
    return parity ? distance_of_runs(question) : two_measurements(question);
}

}  // namespace crossgrain::judge
