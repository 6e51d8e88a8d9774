// Checks between two codes: parity of what must be the same to round-off, equivalence of what must
// be the same within errors.
#include "reference/judge/evaluate.hpp"

#include "reference/compare/parity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

double pair_limit(const catalog::Check& check, const std::string& a, const std::string& b) {
    double limit = check.limit;
    for (const auto& code : {a, b}) {
        if (const auto found = check.limit_for.find(code); found != check.limit_for.end()) {
            limit = std::max(limit, found->second);
        }
    }
    return limit;
}

const measure::Measurement* find_measurement(const measure::Results& results,
                                             const std::string& observable) {
    for (const auto& m : results.measurements) {
        if (m.observable == observable) return &m;
    }
    return nullptr;
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

/// Largest difference over all time steps and the replicas both codes have.
std::optional<double> variant_difference(const CaseRuns& runs, const catalog::Check& check,
                                         std::size_t variant, const std::string& a,
                                         const std::string& b) {
    const auto& the_case = runs.the_case();
    std::optional<double> largest;
    for (std::size_t rung = 0; rung < the_case.variants[variant].rungs; ++rung) {
        const scene::AnyScene scene = the_case.scene(variant, rung, 1);
        const auto* grains = std::get_if<scene::Scene>(&scene);
        const double contact_time = grains == nullptr ? 0 : scene::contact_time(*grains);
        const auto replicas =
            std::min(runs.replicas(a, variant, rung), runs.replicas(b, variant, rung));
        for (std::int64_t replica = 0; replica < replicas; ++replica) {
            const auto difference =
                run_difference(check, contact_time, runs.find(a, variant, rung, replica)->results,
                               runs.find(b, variant, rung, replica)->results);
            if (!difference) return std::nullopt;
            largest = std::max(largest.value_or(0), *difference);
        }
    }
    return largest;
}

struct PairAbsence {
    std::string code;
    Absence absence;
};

/// The first absence of either code.
std::optional<PairAbsence> pair_absence(const CaseRuns& runs, const catalog::Check& check,
                                        std::size_t variant, const std::string& a,
                                        const std::string& b) {
    for (const auto& code : {a, b}) {
        if (auto absent = absence(runs, check, code, variant)) {
            absent->reason = fmt::format("{}: {}", code, absent->reason);
            return PairAbsence{code, *absent};
        }
    }
    return std::nullopt;
}

template <class Judge>
void for_each_pair(const CaseRuns& runs, const catalog::Check& check, Evaluation& evaluation,
                   Judge judge) {
    const auto codes = codes_of(runs, check);
    for (const std::size_t variant : variants_of(runs.the_case(), check)) {
        for (std::size_t i = 0; i < codes.size(); ++i) {
            for (std::size_t j = i + 1; j < codes.size(); ++j) {
                auto verdict = blank_verdict(runs.the_case(), check, codes[i], variant);
                verdict.against.name = codes[j];
                verdict.limit = pair_limit(check, codes[i], codes[j]);
                if (const auto absent = pair_absence(runs, check, variant, codes[i], codes[j])) {
                    verdict.absent_code = absent->code;
                    set_outcome(runs, check, variant, codes[j], absent->absence.outcome,
                                absent->absence.reason, verdict);
                } else {
                    judge(variant, codes[i], codes[j], verdict);
                }
                evaluation.verdicts.push_back(std::move(verdict));
            }
        }
    }
}

/// Round-off that has grown to this length has gone through so many collisions that two programs
/// that order their sums differently cannot be alike to the last bit.
constexpr double grown = 1e-9;

/// LIGGGHTS is a fork of LAMMPS: in a gas the same arithmetic in the same order gives the same bits
/// for good (measured: after 100 contact times still no difference at all). A free lid they do not
/// move alike: the one has its own fix for the plate, the other a formula for the force on each
/// grain and its sum, and their round-off grows apart like that of any other two.
bool share_arithmetic(const CaseRuns& runs, std::size_t variant, const std::string& a,
                      const std::string& b) {
    const auto is_pair = [&](const char* one, const char* other) { return a == one && b == other; };
    if (!is_pair("lammps", "liggghts") && !is_pair("liggghts", "lammps")) return false;
    return !runs.the_case().grain_scene(variant, 0, 1).has_free_lid();
}

/// Doubts pairs without any difference at a time at which round-off has grown between other codes:
/// both read the same output. `judged`: verdicts of the check, with their variants.
void doubt_identical(const CaseRuns& runs, const catalog::Check& check,
                     const std::map<std::size_t, std::size_t>& judged, Evaluation& evaluation) {
    if (!check.at_contact_times) return;
    std::map<std::size_t, double> largest;  // by variant
    for (const auto& [index, variant] : judged) {
        largest[variant] = std::max(largest[variant], evaluation.verdicts[index].difference);
    }
    for (const auto& [index, variant] : judged) {
        auto& verdict = evaluation.verdicts[index];
        if (verdict.difference > 0 || largest[variant] < grown) continue;
        if (share_arithmetic(runs, variant, verdict.code, verdict.against.name)) continue;
        set_outcome(runs, check, variant, verdict.against.name, Outcome::disagree,
                    fmt::format("the same to the last bit, where other codes differ by {:.1g}: do "
                                "both read the same output?",
                                largest[variant]),
                    verdict);
    }
}

std::string place_of(const catalog::Check& check) {
    if (check.at_contact_times) return fmt::format("t = {:g} t_col", *check.at_contact_times);
    if (check.from || check.to) {
        return fmt::format("t = {:g}-{}", check.from.value_or(0),
                           check.to ? fmt::format("{:g}", *check.to) : "end");
    }
    return {};
}

}  // namespace

void evaluate_parity(const CaseRuns& runs, const catalog::Check& check, Evaluation& evaluation) {
    const std::size_t first = evaluation.verdicts.size();
    std::map<std::size_t, std::size_t> judged;
    for_each_pair(
        runs, check, evaluation,
        [&](std::size_t variant, const std::string& a, const std::string& b,
            compare::Verdict& verdict) {
            verdict.place = place_of(check);
            const auto difference = variant_difference(runs, check, variant, a, b);
            if (!difference) {
                return set_outcome(runs, check, variant, b, Outcome::undecided,
                                   "nothing to compare at the same place in both runs", verdict);
            }
            judged[evaluation.verdicts.size()] = variant;
            verdict.difference = *difference;
            const bool same = *difference <= verdict.limit;
            set_outcome(runs, check, variant, b, same ? Outcome::agree : Outcome::disagree,
                        same ? "" : "differs by more than round-off can explain", verdict);
        });
    doubt_identical(runs, check, judged, evaluation);
    for (std::size_t i = first; i < evaluation.verdicts.size(); ++i) {
        evaluation.parity.push_back({&check, i});
    }
}

namespace {

/// Two measurements: equivalent within the margin?
void judge_equivalence(const CaseRuns& runs, const catalog::Check& check, std::size_t variant,
                       const std::string& other, const std::optional<compare::Combined>& a,
                       const std::optional<compare::Combined>& b, compare::Verdict& verdict) {
    if (!a || !b) {
        const std::string& missing = a && !check.with.empty() ? check.with : check.observable;
        return set_outcome(
            runs, check, variant, other, Outcome::undecided,
            fmt::format("'{}' was not measured{}", missing, other.empty() ? "" : " by both"),
            verdict);
    }
    const auto question = compare::question_of(operand_of(*a), operand_of(*b), verdict.limit);
    judge_difference(runs, check, variant, other, question, std::min(a->replicas, b->replicas),
                     verdict);
    const double error = a->measurement.standard_error;
    if (!other.empty() && error > 0 && error == b->measurement.standard_error &&
        verdict.difference == 0) {
        set_outcome(runs, check, variant, other, Outcome::disagree,
                    "value and error are the same to the last bit: do both codes read the same "
                    "output?",
                    verdict);
    }
}

std::optional<std::size_t> variant_named(const catalog::Case& the_case, const std::string& name) {
    for (std::size_t variant = 0; variant < the_case.variants.size(); ++variant) {
        if (the_case.variants[variant].name == name) return variant;
    }
    return std::nullopt;  // left out of the quick suite
}

/// The same code in two variants of the case.
void evaluate_between(const CaseRuns& runs, const catalog::Check& check, Evaluation& evaluation) {
    const auto a = variant_named(runs.the_case(), check.between[0]);
    const auto b = variant_named(runs.the_case(), check.between[1]);
    if (!a || !b) return;
    for (const auto& code : codes_of(runs, check)) {
        auto verdict = blank_verdict(runs.the_case(), check, code, *a);
        auto absence = runs.absence(code, *a);
        if (!absence) absence = runs.absence(code, *b);
        if (absence) {
            set_outcome(runs, check, *a, "", absence->outcome, absence->reason, verdict);
        } else {
            judge_equivalence(runs, check, *a, "", runs.combined(code, *a, 0, check.observable),
                              runs.combined(code, *b, 0, check.observable), verdict);
        }
        evaluation.verdicts.push_back(std::move(verdict));
    }
}

/// Two observables of the same code in the same variant.
void evaluate_with(const CaseRuns& runs, const catalog::Check& check, Evaluation& evaluation) {
    for (const std::size_t variant : variants_of(runs.the_case(), check)) {
        for (const auto& code : codes_of(runs, check)) {
            auto verdict = blank_verdict(runs.the_case(), check, code, variant);
            if (const auto absent = absence(runs, check, code, variant)) {
                set_outcome(runs, check, variant, "", absent->outcome, absent->reason, verdict);
            } else {
                judge_equivalence(runs, check, variant, "",
                                  measured(runs, evaluation, code, variant, check.observable),
                                  measured(runs, evaluation, code, variant, check.with), verdict);
            }
            evaluation.verdicts.push_back(std::move(verdict));
        }
    }
}

}  // namespace

void evaluate_agree(const CaseRuns& runs, const catalog::Check& check, Evaluation& evaluation) {
    if (!check.between.empty()) return evaluate_between(runs, check, evaluation);
    if (!check.with.empty()) return evaluate_with(runs, check, evaluation);
    for_each_pair(runs, check, evaluation,
                  [&](std::size_t variant, const std::string& a, const std::string& b,
                      compare::Verdict& verdict) {
                      judge_equivalence(runs, check, variant, b,
                                        measured(runs, evaluation, a, variant, check.observable),
                                        measured(runs, evaluation, b, variant, check.observable),
                                        verdict);
                  });
}

}  // namespace crossgrain::judge
