#include "app/selftest.hpp"

#include "app/catalogue.hpp"
#include "app/evaluate.hpp"
#include "app/selftest_bench.hpp"
#include "app/selftest_culprit.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain::app {
namespace {

using compare::Outcome;
using compare::Verdict;
using Records = std::vector<store::RunRecord>;

/// Seeds of two samples never meet: this is more than any case has replicas.
constexpr std::uint64_t seed_stride = 10000;

void append(Records& all, Records more) {
    std::ranges::move(more, std::back_inserter(all));
}

double cpu_of(const Records& records) {
    double sum = 0;
    for (const auto& record : records)
        sum += record.cpu_s;
    return sum;
}

bool installed(const std::string& code) {
    return select_codes({code}).front()->probe().installed;
}

/// One defect on its way: what was planned for it, or what came out of planning.
struct PlantedDefect {
    const Defect* defect = nullptr;
    std::string skipped, refusal;
    std::optional<RunSlice> runs;      ///< of the code that carries it
    std::filesystem::path references;  ///< edited published values; empty: the shipped ones
};

struct GroupTrial {
    const DefectGroup* group = nullptr;
    const catalog::Case* the_case = nullptr;
    std::vector<RunSlice> honest;  ///< of all codes, then their peers
    std::vector<PlantedDefect> planted;
};

struct NullTrial {
    const NullComparison* comparison = nullptr;
    const catalog::Case* the_case = nullptr;
    RunSlice a, b;
};

/// Plans what a defect needs. An error of a reader that is to refuse the defect is its result.
PlantedDefect plant(SelftestBench& bench, const catalog::Case& the_case, const DefectGroup& group,
                    const Defect& defect) {
    PlantedDefect planted{.defect = &defect};
    for (const auto& needed : {defect.code, defect.lender}) {
        if (needed.empty() || needed == "published" || installed(needed)) continue;
        planted.skipped = fmt::format("{} is not installed", needed);
        return planted;
    }
    try {
        if (defect.kind == DefectKind::reference) {
            planted.references = bench.edited_references(defect.file, defect.edit, defect.place);
            if (defect.refused) (void)published::PublishedValues(planted.references);
            return planted;
        }
        const catalog::Case* changed = &the_case;
        if (defect.kind == DefectKind::scene) {
            changed = &bench.edited_case(group.case_name, defect.edit, defect.place);
        } else if (defect.kind == DefectKind::reading) {
            changed =
                &bench.case_with_reading(group.case_name, defect.file, defect.edit, defect.place);
        }
        planted.runs =
            bench.plan_defective(the_case, *select_codes({defect.code}).front(), defect, *changed);
    } catch (const CaseError& error) {
        const bool about_the_file =
            !error.details().file.empty() && error.details().file != defect.place;
        if (!defect.refused || !about_the_file) throw;
        planted.refusal = error.what();
    }
    return planted;
}

GroupTrial plan_group(SelftestBench& bench, const DefectGroup& group) {
    GroupTrial trial{.group = &group, .the_case = &bench.find_case(group.case_name)};
    for (const auto* code : select_codes(group.codes)) {
        if (!installed(code->name())) continue;
        trial.honest.push_back(
            bench.plan_runs(*trial.the_case, *code, SelftestBench::first_seed, code->name()));
        for (int peer = 1; peer <= group.peers; ++peer) {
            const auto seed = SelftestBench::first_seed + seed_stride * static_cast<unsigned>(peer);
            trial.honest.push_back(bench.plan_runs(*trial.the_case, *code, seed,
                                                   fmt::format("{}-peer{}", code->name(), peer)));
        }
    }
    for (const auto& defect : group.defects)
        trial.planted.push_back(plant(bench, *trial.the_case, group, defect));
    return trial;
}

std::vector<NullTrial> plan_null(SelftestBench& bench, const NullComparison& null,
                                 std::uint64_t& seed) {
    std::vector<NullTrial> trials;
    if (!installed(null.code) || !installed(null.against)) return trials;
    const catalog::Case& the_case = bench.find_case(null.case_name);
    const catalog::Case& other =
        null.edit ? bench.edited_case(null.case_name, *null.edit, null.place) : the_case;
    const auto next = [&] { return seed += seed_stride; };
    for (int round = 0; round < null.rounds; ++round) {
        NullTrial trial{.comparison = &null, .the_case = &the_case};
        trial.a = bench.plan_runs(the_case, *select_codes({null.code}).front(), next(), null.code);
        trial.b = bench.plan_runs(other, *select_codes({null.against}).front(), next(),
                                  null.against + ", other seeds");
        trials.push_back(std::move(trial));
    }
    return trials;
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

class Judge {
  public:
    explicit Judge(const SelftestBench& bench)
        : bench_(bench), literature_(share_directory() / "published") {}

    void judge_group(const GroupTrial& trial, SelftestReport& report) const;
    void judge_null(const NullTrial& trial, SelftestReport& report) const;

  private:
    [[nodiscard]] std::vector<Verdict> verdicts(const catalog::Case& the_case,
                                                Records records) const {
        return evaluate(CaseRuns(the_case, std::move(records)), literature_).verdicts;
    }
    [[nodiscard]] DefectResult judge_defect(const GroupTrial& trial, const PlantedDefect& planted,
                                            const std::vector<Verdict>& before) const;
    [[nodiscard]] Records with_defect(const GroupTrial& trial, const PlantedDefect& planted,
                                      double& cpu_s) const;

    const SelftestBench& bench_;
    published::PublishedValues literature_;
};

/// The honest runs with those of the defective code in their place.
Records Judge::with_defect(const GroupTrial& trial, const PlantedDefect& planted,
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

std::string base_name(const std::string& observable) {
    return observable.substr(0, observable.find_first_of(". "));
}

void fill_in(DefectResult& result, const Defect& defect, const std::vector<Verdict>& objections,
             const std::vector<Verdict>& all) {
    if (objections.empty()) return;
    const auto culprit = culprit_of(objections, all);
    const Verdict& v = most_telling(objections, culprit);
    result.caught = true;
    result.culprit = culprit.value_or("");
    result.observable = v.observable;
    result.reason = v.reason;
    result.by = fmt::format("{}: {} {} of {}", compare::to_string(v.outcome),
                            compare::to_string(v.kind), v.observable, v.code);
    if (!v.against.empty()) result.by += " against " + v.against;
    const auto& wanted = defect.shows_in;
    const bool right_observable =
        wanted.empty() || v.outcome == Outcome::run_failed ||
        std::ranges::find(wanted, base_name(v.observable)) != wanted.end();
    result.culprit_right = culprit == defect.code && right_observable;
}

DefectResult Judge::judge_defect(const GroupTrial& trial, const PlantedDefect& planted,
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
    const auto after = evaluate(CaseRuns(*trial.the_case, std::move(records)), literature).verdicts;
    fill_in(result, defect, new_objections(before, after), after);
    return result;
}

void Judge::judge_group(const GroupTrial& trial, SelftestReport& report) const {
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
                                            v.observable, v.code, v.against, v.reason),
                         .expected = "every verdict as expected"});
    }
    for (const auto& planted : trial.planted) {
        report.defects.push_back(judge_defect(trial, planted, before));
        report.cpu_s += report.defects.back().cpu_s;
    }
}

void Judge::judge_null(const NullTrial& trial, SelftestReport& report) const {
    Records records = bench_.records(trial.a);
    append(records, bench_.records(trial.b));
    report.null.cpu_s += cpu_of(records);
    for (const auto& v : verdicts(*trial.the_case, std::move(records))) {
        ++report.null.comparisons;
        if (v.outcome == Outcome::undecided) ++report.null.undecided;
        if (v.outcome == Outcome::disagree || v.outcome == Outcome::run_failed) {
            ++report.null.false_alarms;
            report.null.alarms.push_back(fmt::format("{} {} [{}] of {} against {}: {}",
                                                     trial.the_case->name, v.observable, v.setting,
                                                     v.code, v.against, v.reason));
        }
        if (v.kind != compare::Kind::agree || !(v.uncertainty > 0)) continue;
        ++report.null.with_interval;
        if (std::abs(v.difference) > v.uncertainty) ++report.null.misses;
    }
}

}  // namespace

std::size_t SelftestReport::planted() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(defects, [](const auto& d) { return d.skipped.empty(); }));
}

std::size_t SelftestReport::caught() const {
    return static_cast<std::size_t>(std::ranges::count_if(defects, &DefectResult::caught));
}

std::size_t SelftestReport::culprits_right() const {
    return static_cast<std::size_t>(std::ranges::count_if(defects, &DefectResult::culprit_right));
}

bool SelftestReport::passed() const {
    constexpr double most_alarms = 0.02, fewest_culprits = 0.9;
    const auto part = [](std::size_t some, double share, std::size_t all) {
        return static_cast<double>(some) <= share * static_cast<double>(all);
    };
    return !interrupted && caught() == planted() &&
           part(null.false_alarms, most_alarms, null.comparisons) &&
           part(caught() - culprits_right(), 1 - fewest_culprits, caught());
}

SelftestReport run_selftest(const SelftestCatalogue& catalogue, const Settings& settings,
                            std::stop_token stop) {
    SelftestBench bench(settings);
    std::vector<GroupTrial> groups;
    for (const auto& group : catalogue.groups)
        groups.push_back(plan_group(bench, group));
    std::vector<NullTrial> nulls;
    std::uint64_t seed = seed_stride * 100;  // beyond those of peers
    for (const auto& null : catalogue.nulls)
        std::ranges::move(plan_null(bench, null, seed), std::back_inserter(nulls));
    bench.carry_out(stop);
    SelftestReport report{.interrupted = bench.interrupted()};
    if (report.interrupted) return report;
    const Judge judge(bench);
    for (const auto& group : groups)
        judge.judge_group(group, report);
    for (const auto& null : nulls)
        judge.judge_null(null, report);
    report.cpu_s += report.null.cpu_s;
    return report;
}

}  // namespace crossgrain::app
