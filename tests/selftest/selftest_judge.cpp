#include "tests/selftest/selftest_judge.hpp"

#include "native/base/share_directory.hpp"

#include "native/base/errors.hpp"
#include "reference/judge/evaluate.hpp"
#include "tests/selftest/selftest_culprit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace crossgrain::selftest {
namespace {

using compare::Outcome;
using compare::Verdict;
using Records = std::vector<store::RunRecord>;

void append(Records& all, Records more) {
    std::ranges::move(more, std::back_inserter(all));
}

double cpu_of(const Records& records) {
    double sum = 0;
    for (const auto& record : records)
        sum += record.cpu_s;
    return sum;
}

void spoil(Records& records, const Defect& defect) {
    if (defect.kind != DefectKind::results) return;
    bool found = false;
    for (auto& record : records) {
        for (auto& m : record.results.measurements) {
            if (m.observable != defect.spoiled) continue;
            m.value *= defect.factor;
            m.standard_error *= defect.error_factor;
            found = true;
        }
    }
    if (found) return;
    throw CaseError({.file = defect.place,
                     .key = "defect.measurement",
                     .problem = "was not measured",
                     .got = fmt::format("\"{}\"", defect.spoiled),
                     .expected = "a measurement of the case"});
}

void fill_in(DefectResult& result, const Defect& defect, const std::vector<Verdict>& objections,
             const std::vector<Verdict>& all) {
    if (objections.empty()) return;
    const auto culprit = culprit_of(objections, all);
    const Verdict& v = most_telling(objections, culprit);
    result.caught = true;
    result.culprit = culprit.value_or("");
    result.observable = compare::observable_text(v);
    result.reason = v.reason;
    result.by = fmt::format("{}: {} {} of {}", compare::to_string(v.outcome),
                            compare::to_string(v.kind), compare::observable_text(v), v.code);
    if (const auto against = compare::to_string(v.against); !against.empty())
        result.by += " against " + against;
    const auto& wanted = defect.shows_in;
    const bool right_observable = wanted.empty() || v.outcome == Outcome::run_failed ||
                                  std::ranges::find(wanted, v.observable) != wanted.end();
    result.culprit_right = culprit == defect.code && right_observable;
}

}  // namespace

SelftestJudge::SelftestJudge(const SelftestBench& bench)
    : bench_(bench), literature_(share_directory() / "published") {}

std::vector<Verdict> SelftestJudge::verdicts(const catalog::Case& the_case, Records records) const {
    return judge::evaluate(judge::CaseRuns(the_case, std::move(records)), literature_).verdicts;
}

/// The honest runs with those of the defective code in their place.
SelftestJudge::Records SelftestJudge::with_defect(const GroupTrial& trial,
                                                  const PlantedDefect& planted,
                                                  double& cpu_s) const {
    Records all;
    for (const auto& slice : trial.honest) {
        const bool carries = slice.label == planted.defect->code;
        Records own = bench_.records(carries && planted.runs ? *planted.runs : slice);
        if (carries) {
            cpu_s = cpu_of(own);
            spoil(own, *planted.defect);
        }
        append(all, std::move(own));
    }
    return all;
}

DefectResult SelftestJudge::judge_defect(const GroupTrial& trial, const PlantedDefect& planted,
                                         const std::vector<Verdict>& before) const {
    const Defect& defect = *planted.defect;
    DefectResult result{.name = defect.name,
                        .kind = to_string(defect.kind),
                        .case_name = trial.the_case->name,
                        .code = defect.code,
                        .skipped = planted.skipped};
    if (!planted.skipped.empty()) return result;
    if (!planted.refusal.empty()) {
        result.caught = result.culprit_right = true;
        result.culprit = defect.code;
        result.by = "refused when it is read";
        result.reason = planted.refusal;
        return result;
    }
    const auto literature =
        planted.references.empty() ? literature_ : published::PublishedValues(planted.references);
    Records records = with_defect(trial, planted, result.cpu_s);
    const auto after =
        judge::evaluate(judge::CaseRuns(*trial.the_case, std::move(records)), literature).verdicts;
    fill_in(result, defect, new_objections(before, after), after);
    return result;
}

void SelftestJudge::judge_group(const GroupTrial& trial, SelftestReport& report) const {
    Records honest;
    for (const auto& slice : trial.honest)
        append(honest, bench_.records(slice));
    report.cpu_s += cpu_of(honest);
    const auto before = verdicts(*trial.the_case, std::move(honest));
    for (const auto& v : before) {
        if (v.expected) continue;
        throw CaseError({.file = trial.the_case->file,
                         .problem = "is not clean without any defect",
                         .got = fmt::format("{}: {} of {} {}: {}", compare::to_string(v.outcome),
                                            compare::observable_text(v), v.code,
                                            compare::to_string(v.against), v.reason),
                         .expected = "every verdict as expected"});
    }
    for (const auto& planted : trial.planted) {
        report.defects.push_back(judge_defect(trial, planted, before));
        report.cpu_s += report.defects.back().cpu_s;
    }
}

void SelftestJudge::judge_null(const NullTrial& trial, SelftestReport& report) const {
    Records records = bench_.records(trial.a);
    append(records, bench_.records(trial.b));
    report.null.cpu_s += cpu_of(records);
    for (const auto& v : verdicts(*trial.the_case, std::move(records))) {
        ++report.null.comparisons;
        if (v.outcome == Outcome::undecided) ++report.null.undecided;
        if (v.outcome == Outcome::disagree || v.outcome == Outcome::run_failed) {
            ++report.null.false_alarms;
            report.null.alarms.push_back(
                fmt::format("{} {} [{}] of {} against {}: {}", trial.the_case->name,
                            compare::observable_text(v), compare::setting_text(v), v.code,
                            compare::to_string(v.against), v.reason));
        }
        if (v.kind != compare::Kind::agree || !(v.uncertainty > 0)) continue;
        ++report.null.with_interval;
        if (std::abs(v.difference) > v.uncertainty) ++report.null.misses;
    }
}

}  // namespace crossgrain::selftest
