// What the verdicts say of each trial of a selftest: whether a planted defect was caught, by what,
// whom it is blamed on, and what was objected to where nothing is wrong.
#pragma once

#include "adapters/run/store/store.hpp"
#include "reference/compare/verdict.hpp"
#include "reference/published/published.hpp"
#include "tests/selftest/selftest.hpp"
#include "tests/selftest/selftest_trials.hpp"

#include <vector>

namespace crossgrain::selftest {

class SelftestJudge {
  public:
    /// `bench`: after carry_out.
    explicit SelftestJudge(const SelftestBench& bench);

    /// Appends a result for each defect of the group. Throws CaseError if the case is not clean
    /// without any.
    void judge_group(const GroupTrial& trial, SelftestReport& report) const;
    void judge_null(const NullTrial& trial, SelftestReport& report) const;

  private:
    using Records = std::vector<store::RunRecord>;

    [[nodiscard]] std::vector<compare::Verdict> verdicts(const catalog::Case& the_case,
                                                         Records records) const;
    [[nodiscard]] DefectResult judge_defect(const GroupTrial& trial, const PlantedDefect& planted,
                                            const std::vector<compare::Verdict>& before) const;
    [[nodiscard]] Records with_defect(const GroupTrial& trial, const PlantedDefect& planted,
                                      double& cpu_s) const;

    const SelftestBench& bench_;
    published::PublishedValues literature_;
};

}  // namespace crossgrain::selftest
