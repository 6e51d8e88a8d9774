#include "tests/selftest/selftest.hpp"

#include "tests/selftest/selftest_bench.hpp"
#include "tests/selftest/selftest_judge.hpp"
#include "tests/selftest/selftest_trials.hpp"

#include <algorithm>
#include <iterator>

namespace crossgrain::selftest {

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

SelftestReport run_selftest(const SelftestCatalogue& catalogue, const run::Settings& settings,
                            std::stop_token stop) {
    SelftestBench bench(settings);
    std::vector<GroupTrial> groups;
    for (const auto& group : catalogue.groups)
        groups.push_back(plan_group(bench, group));
    std::vector<NullTrial> nulls;
    std::uint64_t seed = first_null_seed();
    for (const auto& null : catalogue.nulls)
        std::ranges::move(plan_null(bench, null, seed), std::back_inserter(nulls));
    bench.carry_out(stop);
    SelftestReport report{.interrupted = bench.interrupted()};
    if (report.interrupted) return report;
    const SelftestJudge judge(bench);
    for (const auto& group : groups)
        judge.judge_group(group, report);
    for (const auto& null : nulls)
        judge.judge_null(null, report);
    report.cpu_s += report.null.cpu_s;
    return report;
}

}  // namespace crossgrain::selftest
