#include "reference/judge/evaluate.hpp"

#include "cases/scene/any_scene.hpp"
#include "reference/judge/question.hpp"

#include <algorithm>

namespace crossgrain::judge {
namespace {

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

compare::Operand operand_of(const compare::Combined& combined) {
    return {.value = combined.measurement.value,
            .standard_error = combined.measurement.standard_error,
            .degrees_of_freedom = combined.degrees_of_freedom};
}

Evaluation evaluate(const CaseRuns& runs, const published::PublishedValues& literature) {
    Evaluation evaluation;
    collect_measurements(runs, evaluation);
    evaluate_fits(runs, evaluation);
    for (const auto& check : runs.the_case().checks) {
        for (Question& question : answer_check(runs, check, literature, evaluation)) {
            if (check.kind == catalog::CheckKind::parity) {
                evaluation.parity.push_back({&check, evaluation.verdicts.size()});
            }
            if (question.curve) evaluation.curves.push_back(std::move(*question.curve));
            evaluation.verdicts.push_back(std::move(question.verdict));
        }
    }
    evaluate_certificate(runs, evaluation);
    return evaluation;
}

}  // namespace crossgrain::judge
