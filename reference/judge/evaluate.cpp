#include "reference/judge/evaluate.hpp"

#include "cases/scene/any_scene.hpp"
#include "reference/compare/equivalence_power.hpp"

#include <algorithm>
#include <set>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

compare::Kind kind_of(catalog::CheckKind kind) {
    switch (kind) {
    case catalog::CheckKind::exact:
        return compare::Kind::exact;
    case catalog::CheckKind::parity:
        return compare::Kind::parity;
    case catalog::CheckKind::agree:
        return compare::Kind::agree;
    case catalog::CheckKind::published:
        break;
    }
    return compare::Kind::published;
}

compare::Aspect aspect_of(catalog::Aspect aspect) {
    switch (aspect) {
    case catalog::Aspect::value:
        break;
    case catalog::Aspect::limit:
        return compare::Aspect::limit;
    case catalog::Aspect::order:
        return compare::Aspect::order;
    case catalog::Aspect::constant:
        return compare::Aspect::constant;
    case catalog::Aspect::increasing:
        return compare::Aspect::increasing;
    case catalog::Aspect::decreasing:
        return compare::Aspect::decreasing;
    }
    return compare::Aspect::value;
}

/// What the check names; of a pair the second code is not known yet.
compare::Against against_of(const catalog::Check& check) {
    using Kind = compare::Against::Kind;
    if (!check.between.empty()) return {Kind::variant, check.between[1]};
    if (!check.with.empty()) return {Kind::own_observable, check.with};
    if (check.kind == catalog::CheckKind::exact)
        return {Kind::closed_form, to_string(check.against)};
    if (check.kind != catalog::CheckKind::published) return {Kind::code, ""};
    return {catalog::is_trend(check.aspect) ? Kind::trend : Kind::published,
            to_string(check.against)};
}

std::string rule_variant_of(const catalog::Variant& variant) {
    if (variant.parameters.empty()) return {};
    const auto& [key, value] = variant.parameters.front();
    return key == "reading" ? value : "";
}

void collect_measurements(const CaseRuns& runs, Evaluation& evaluation) {
    const auto& the_case = runs.the_case();
    for (const auto& code : runs.codes()) {
        for (std::size_t variant = 0; variant < the_case.variants.size(); ++variant) {
            for (std::size_t rung = 0; rung < the_case.variants[variant].rungs; ++rung) {
                const auto* first = runs.find(code, variant, rung, 0);
                if (first == nullptr) continue;
                const double dt = scene::time_step_of(the_case.scene(variant, rung, first->seed));
                for (const auto& m : first->results.measurements) {
                    if (auto all = runs.combined(code, variant, rung, m.observable)) {
                        evaluation.measurements.push_back(
                            {.code = code,
                             .variant = the_case.variants[variant].name,
                             .rung = rung,
                             .dt = dt,
                             .combined = std::move(*all)});
                    }
                }
            }
        }
    }
}

}  // namespace

bool is_fitted(const catalog::Case& the_case, const std::string& observable) {
    return std::ranges::any_of(the_case.fits, [&](const catalog::Fit& fit) {
        switch (fit.law) {
        case catalog::FitLaw::local_slope:
            return false;
        case catalog::FitLaw::outlet:
            return observable == fit.name + "_factor" || observable == fit.name + "_cut";
        default:
            return observable == fit.name;
        }
    });
}

std::optional<compare::Combined> measured(const CaseRuns& runs, const Evaluation& evaluation,
                                          const std::string& code, std::size_t variant,
                                          const std::string& observable) {
    if (auto own = runs.combined(code, variant, 0, observable)) return own;
    const bool fitted = is_fitted(runs.the_case(), observable);
    const std::string place = fitted ? "" : runs.the_case().variants[variant].name;
    const auto found = std::ranges::find_if(evaluation.measurements, [&](const auto& m) {
        return m.code == code && m.variant == place && m.rung == 0 &&
               m.combined.measurement.observable == observable;
    });
    if (found == evaluation.measurements.end()) return std::nullopt;
    return found->combined;
}

std::optional<Absence> absence(const CaseRuns& runs, const catalog::Check& check,
                               const std::string& code, std::size_t variant) {
    if (!is_fitted(runs.the_case(), check.observable)) return runs.absence(code, variant);
    std::optional<Absence> first;
    bool any_run = false;
    for (std::size_t v = 0; v < runs.the_case().variants.size(); ++v) {
        const auto here = runs.absence(code, v);
        if (here && here->outcome == Outcome::run_failed) return here;
        if (!here) any_run = true;
        if (!first) first = here;
    }
    return any_run ? std::nullopt : first;
}

std::vector<std::size_t> variants_of(const catalog::Case& the_case, const catalog::Check& check) {
    if (is_fitted(the_case, check.observable)) return {0};
    std::vector<std::size_t> result;
    for (std::size_t variant = 0; variant < the_case.variants.size(); ++variant) {
        const auto& wanted = check.variants;
        const std::string& name = the_case.variants[variant].name;
        const bool asked =
            wanted.empty() || std::any_of(wanted.begin(), wanted.end(), [&](const auto& pattern) {
                return catalog::matches(pattern, name);
            });
        if (asked) result.push_back(variant);
    }
    return result;
}

std::vector<std::string> codes_of(const CaseRuns& runs, const catalog::Check& check) {
    if (check.codes.empty()) return runs.codes();
    std::vector<std::string> result;
    for (const auto& code : runs.codes()) {
        if (std::find(check.codes.begin(), check.codes.end(), code) != check.codes.end()) {
            result.push_back(code);
        }
    }
    return result;
}

compare::Verdict blank_verdict(const catalog::Case& the_case, const catalog::Check& check,
                               const std::string& code, std::size_t variant) {
    compare::Verdict verdict{.code = code,
                             .observable = check.observable,
                             .column = check.column,
                             .aspect = aspect_of(check.aspect),
                             .along = check.along,
                             .kind = kind_of(check.kind),
                             .against = against_of(check),
                             .variant = the_case.variants[variant].name,
                             .rule_variant = rule_variant_of(the_case.variants[variant]),
                             .limit = check.limit,
                             .limit_reason = check.reason};
    if (is_fitted(the_case, check.observable)) {
        verdict.variant.clear();
        verdict.rule_variant.clear();
    }
    return verdict;
}

compare::Operand operand_of(const compare::Combined& combined) {
    return {.value = combined.measurement.value,
            .standard_error = combined.measurement.standard_error,
            .degrees_of_freedom = combined.degrees_of_freedom};
}

void judge_difference(const CaseRuns& runs, const catalog::Check& check, std::size_t variant,
                      const std::string& other, const compare::EquivalenceQuestion& question,
                      std::size_t replicas, compare::Verdict& verdict) {
    const auto answer = compare::equivalence(question);
    verdict.difference = question.difference;
    verdict.uncertainty = answer.half_width_95;
    verdict.standard_error = question.standard_error;
    compare::state_evidence(question, replicas, verdict);
    set_outcome(runs, check, variant, other, answer.outcome, answer.reason, verdict);
}

void set_outcome(const CaseRuns& runs, const catalog::Check& check, std::size_t variant,
                 const std::string& other, Outcome outcome, const std::string& reason,
                 compare::Verdict& verdict) {
    std::string wanted = check.expect;
    for (const auto& code : {verdict.code, other}) {
        if (const auto found = check.expect_for.find(code); found != check.expect_for.end()) {
            wanted = found->second;
        }
    }
    for (const auto& [pattern, outcome_there] : check.expect_in) {
        if (is_fitted(runs.the_case(), check.observable)) break;  // belongs to no variant
        if (catalog::matches(pattern, runs.the_case().variants[variant].name)) {
            wanted = outcome_there;
        }
    }
    const bool known_gap = outcome == Outcome::not_expressible &&
                           (runs.known_not_expressible(verdict.code, variant) ||
                            (!other.empty() && runs.known_not_expressible(other, variant)));
    verdict.outcome = outcome;
    verdict.expected = known_gap || compare::to_string(outcome) == wanted;
    verdict.reason = reason;
    if (outcome != Outcome::agree && verdict.expected && !check.expect_reason.empty()) {
        verdict.reason += (reason.empty() ? "" : "; ") + ("expected: " + check.expect_reason);
    }
    if (outcome == Outcome::agree && !verdict.expected) {
        verdict.reason = "agrees although the catalogue records '" + wanted + "' (" +
                         check.expect_reason + "): update the catalogue";
    }
}

Evaluation evaluate(const CaseRuns& runs, const published::PublishedValues& literature) {
    Evaluation evaluation;
    collect_measurements(runs, evaluation);
    evaluate_fits(runs, evaluation);
    for (const auto& check : runs.the_case().checks) {
        switch (check.kind) {
        case catalog::CheckKind::exact:
            evaluate_exact(runs, check, evaluation);
            break;
        case catalog::CheckKind::parity:
            evaluate_parity(runs, check, evaluation);
            break;
        case catalog::CheckKind::agree:
            evaluate_agree(runs, check, evaluation);
            break;
        case catalog::CheckKind::published:
            if (catalog::is_trend(check.aspect)) {
                evaluate_trend(runs, check, literature, evaluation);
            } else {
                evaluate_published(runs, check, literature, evaluation);
            }
            break;
        }
    }
    evaluate_certificate(runs, evaluation);
    return evaluation;
}

}  // namespace crossgrain::judge
