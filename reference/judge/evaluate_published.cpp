// Checks against numbers of the literature.
#include "reference/judge/evaluate.hpp"

#include "reference/compare/equivalence_power.hpp"

#include <fmt/format.h>

#include <cmath>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

void judge(const CaseRuns& runs, const Evaluation& evaluation, const catalog::Check& check,
           std::size_t variant, const published::PublishedValue& reference,
           compare::Verdict& verdict) {
    const auto combined = measured(runs, evaluation, verdict.code, variant, check.observable);
    if (!combined) {
        return conclude(runs, check, variant, "", Outcome::undecided,
                        fmt::format("'{}' was not measured", check.observable), verdict);
    }
    const auto& m = combined->measurement;
    const compare::EquivalenceQuestion question{.difference = m.value - reference.value,
                                                .standard_error =
                                                    std::hypot(m.standard_error, reference.error),
                                                .degrees_of_freedom = combined->degrees_of_freedom,
                                                .margin = verdict.limit};
    const auto answer = compare::equivalence(question);
    compare::state_evidence(question, combined->replicas, verdict);
    verdict.reference = reference.value;
    verdict.reference_error = reference.error;
    verdict.difference = m.value - reference.value;
    verdict.uncertainty = answer.half_width_95;
    conclude(runs, check, variant, "", answer.outcome, answer.reason, verdict);
}

}  // namespace

std::string published_id(const catalog::Check& check) {
    constexpr std::string_view prefix = "published:";
    return check.against.starts_with(prefix) ? check.against.substr(prefix.size()) : check.against;
}

void evaluate_published(const CaseRuns& runs, const catalog::Check& check,
                        const published::PublishedValues& literature, Evaluation& evaluation) {
    const std::string id = published_id(check);
    auto reference = literature.find(id);
    if (reference && !reference->trend.empty()) reference.reset();  // has no number to compare with
    for (const std::size_t variant : variants_of(runs.the_case(), check)) {
        for (const auto& code : codes_of(runs, check)) {
            auto verdict = blank_verdict(runs.the_case(), check, code, variant);
            if (const auto absent = absence(runs, check, code, variant)) {
                conclude(runs, check, variant, "", absent->outcome, absent->reason, verdict);
            } else if (!reference) {
                conclude(runs, check, variant, "", Outcome::no_reference,
                         fmt::format("no published value '{}'", id), verdict);
            } else {
                judge(runs, evaluation, check, variant, *reference, verdict);
            }
            evaluation.verdicts.push_back(std::move(verdict));
        }
    }
}

}  // namespace crossgrain::judge
