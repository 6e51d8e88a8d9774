// Checks against numbers of the literature.
#include "reference/judge/evaluate.hpp"

#include <fmt/format.h>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

void judge(const CaseRuns& runs, const Evaluation& evaluation, const catalog::Check& check,
           std::size_t variant, const published::PublishedValue& reference,
           compare::Verdict& verdict) {
    const auto combined = measured(runs, evaluation, verdict.code, variant, check.observable);
    if (!combined) {
        return set_outcome(runs, check, variant, "", Outcome::undecided,
                           fmt::format("'{}' was not measured", check.observable), verdict);
    }
    verdict.reference = reference.value;
    verdict.reference_error = reference.error;
    const auto question = compare::question_of(
        operand_of(*combined), {.value = reference.value, .standard_error = reference.error},
        verdict.limit);
    judge_difference(runs, check, variant, "", question, combined->replicas, verdict);
}

}  // namespace

void evaluate_published(const CaseRuns& runs, const catalog::Check& check,
                        const published::PublishedValues& literature, Evaluation& evaluation) {
    const std::string& id = check.against.name;
    auto reference = literature.find(id);
    if (reference && !reference->trend.empty()) reference.reset();  // has no number to compare with
    for (const std::size_t variant : variants_of(runs.the_case(), check)) {
        for (const auto& code : codes_of(runs, check)) {
            auto verdict = blank_verdict(runs.the_case(), check, code, variant);
            if (const auto absent = absence(runs, check, code, variant)) {
                set_outcome(runs, check, variant, "", absent->outcome, absent->reason, verdict);
            } else if (!reference) {
                set_outcome(runs, check, variant, "", Outcome::no_reference,
                            fmt::format("no published value '{}'", id), verdict);
            } else {
                judge(runs, evaluation, check, variant, *reference, verdict);
            }
            evaluation.verdicts.push_back(std::move(verdict));
        }
    }
}

}  // namespace crossgrain::judge
