// Checks against closed forms: of single values, of their limit for dt -> 0, of the order of
// convergence.
#include "reference/judge/evaluate.hpp"
#include "reference/oracles/oracles.hpp"

#include "reference/compare/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

/// Below this, an error is round-off and has no order in dt.
constexpr double round_off = 1e-12;

struct Deviation {
    double dt = 0;
    double error = 0;  ///< measured - exact
    compare::Combined combined;
};

double exact_of(const Deviation& deviation) {
    return deviation.combined.measurement.value - deviation.error;
}

/// Measured minus exact for each time step of the ladder, or why there is none.
struct Deviations {
    std::vector<Deviation> rungs;
    Outcome problem = Outcome::agree;  ///< agree: none
    std::string reason;
};

Deviations deviations(const CaseRuns& runs, const catalog::Check& check, const std::string& code,
                      std::size_t variant) {
    const auto& the_case = runs.the_case();
    Deviations result;
    for (std::size_t rung = 0; rung < the_case.variants[variant].rungs; ++rung) {
        const auto combined = runs.combined(code, variant, rung, check.observable);
        if (!combined) {
            return {.rungs = {},
                    .problem = Outcome::undecided,
                    .reason = fmt::format("'{}' was not measured", check.observable)};
        }
        const auto scene = the_case.scene(variant, rung, 1);
        const auto exact = oracles::exact_value(to_string(check.against), scene);
        if (!exact) {
            return {.rungs = {},
                    .problem = Outcome::no_reference,
                    .reason = fmt::format("no '{}' for this scene", to_string(check.against))};
        }
        result.rungs.push_back(
            {scene::time_step_of(scene), combined->measurement.value - *exact, *combined});
    }
    return result;
}

compare::Rung rung_of(const Deviation& deviation) {
    const auto& m = deviation.combined.measurement;
    const auto n = static_cast<double>(m.n);
    const double scatter = m.standard_error * std::sqrt(std::max(0.0, n - 1));
    const double rms = std::hypot(deviation.error, scatter);
    return {.dt = deviation.dt,
            .mean_error = deviation.error,
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
std::vector<compare::Rung> pooled_rungs(const std::vector<Deviation>& deviations) {
    std::vector<compare::Rung> single;
    single.reserve(deviations.size());
    for (const auto& deviation : deviations)
        single.push_back(rung_of(deviation));
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

void judge_values(const CaseRuns& runs, const catalog::Check& check, std::size_t variant,
                  const std::vector<Deviation>& rungs, compare::Verdict& verdict) {
    const Deviation* worst = &rungs.front();
    for (const auto& deviation : rungs) {
        if (!(std::abs(deviation.error) <= std::abs(worst->error))) worst = &deviation;
    }
    verdict.reference = exact_of(*worst);
    auto question =
        compare::question_of(operand_of(worst->combined), {.value = exact_of(*worst)}, check.limit);
    question.difference = worst->error;  // to the last bit
    judge_difference(runs, check, variant, "", question, worst->combined.replicas, verdict);
}

void judge_convergence(const CaseRuns& runs, const catalog::Check& check, std::size_t variant,
                       const std::vector<Deviation>& deviations, Evaluation& evaluation,
                       compare::Verdict& verdict) {
    const bool wants_order = check.aspect == catalog::Aspect::order;
    const std::vector<compare::Rung> rungs = pooled_rungs(deviations);
    ConvergenceCurve curve{
        .code = verdict.code, .variant = verdict.variant, .observable = check.observable};
    bool exact_to_round_off = true;
    for (const auto& rung : rungs) {
        curve.dt.push_back(rung.dt);
        curve.mean_error.push_back(rung.mean_error);
        curve.rms_error.push_back(rung.rms_error);
        exact_to_round_off = exact_to_round_off && rung.rms_error < round_off;
    }
    if (exact_to_round_off) {
        if (!wants_order) return judge_values(runs, check, variant, deviations, verdict);
        return set_outcome(runs, check, variant, "", Outcome::undecided,
                           "the error is round-off at every dt: it has no order", verdict);
    }
    try {
        const compare::Convergence fit = compare::convergence(rungs);
        curve.order = fit.order.value;
        curve.order_error = fit.order.standard_error;
        curve.order_degrees_of_freedom = fit.order.degrees_of_freedom;
        curve.limit = fit.limit.value;
        curve.limit_error = fit.limit.standard_error;
        const compare::Estimate& estimate = wants_order ? fit.order : fit.limit;
        if (!wants_order) verdict.reference = exact_of(deviations.front());
        judge_difference(runs, check, variant, "",
                         {.difference = wants_order ? estimate.value - check.order : estimate.value,
                          .standard_error = estimate.standard_error,
                          .degrees_of_freedom = estimate.degrees_of_freedom,
                          .margin = check.limit},
                         deviations.front().combined.replicas, verdict);
        if (wants_order) evaluation.curves.push_back(std::move(curve));
    } catch (const std::invalid_argument& error) {
        set_outcome(runs, check, variant, "", Outcome::undecided, error.what(), verdict);
    }
}

}  // namespace

void evaluate_exact(const CaseRuns& runs, const catalog::Check& check, Evaluation& evaluation) {
    for (const std::size_t variant : variants_of(runs.the_case(), check)) {
        for (const auto& code : codes_of(runs, check)) {
            compare::Verdict verdict = blank_verdict(runs.the_case(), check, code, variant);
            if (const auto absence = runs.absence(code, variant)) {
                set_outcome(runs, check, variant, "", absence->outcome, absence->reason, verdict);
            } else if (const auto found = deviations(runs, check, code, variant);
                       found.problem != Outcome::agree) {
                set_outcome(runs, check, variant, "", found.problem, found.reason, verdict);
            } else if (check.aspect == catalog::Aspect::value) {
                judge_values(runs, check, variant, found.rungs, verdict);
            } else {
                judge_convergence(runs, check, variant, found.rungs, evaluation, verdict);
            }
            evaluation.verdicts.push_back(std::move(verdict));
        }
    }
}

}  // namespace crossgrain::judge
