// A case with its runs and what is said of them.
#pragma once

#include "reference/judge/case_runs.hpp"
#include "reference/judge/evaluate.hpp"

#include <memory>
#include <vector>

namespace crossgrain::judge {

struct CaseReport {
    std::shared_ptr<const catalog::Case> the_case;
    CaseRuns runs;
    Evaluation evaluation;
};

/// Sets `corrected` of all verdicts that rest on statistics. They are two families, each held to a
/// chance of 5 % for one false claim or more among all of the report: `disagree` by the p-values
/// against equivalence, `agree` by those against non-equivalence. What is neither after correction
/// is `undecided`. Numbers without scatter, trends (which correct themselves, by pairs of points)
/// and what was not compared are no members.
void correct_for_many(std::vector<CaseReport>& cases);

}  // namespace crossgrain::judge
