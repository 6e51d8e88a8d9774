#include "reference/compare/holm.hpp"
#include "reference/judge/case_report.hpp"

#include <cmath>

namespace crossgrain::judge {
namespace {

using compare::Outcome;
using compare::Verdict;

constexpr double level = 0.05;

/// Whether statistics decide it; the others are comparisons of numbers.
bool is_claim(const Verdict& v) {
    const bool compared = v.outcome == Outcome::agree || v.outcome == Outcome::disagree ||
                          v.outcome == Outcome::undecided;
    return compared && v.uncertainty > 0 && !std::isnan(v.p_equivalent);
}

}  // namespace

void correct_for_many(std::vector<CaseReport>& cases) {
    std::vector<Verdict*> claims;
    std::vector<double> equivalent, different;
    for (auto& item : cases) {
        for (auto& v : item.evaluation.verdicts) {
            if (!is_claim(v)) continue;
            claims.push_back(&v);
            equivalent.push_back(v.p_equivalent);
            different.push_back(v.p_different);
        }
    }
    const auto agrees = compare::holm(equivalent), disagrees = compare::holm(different);
    for (std::size_t i = 0; i < claims.size(); ++i) {
        // Some disagreements are not about the size of a difference: they stay what they are.
        const bool by_statistics =
            claims[i]->outcome != Outcome::disagree || claims[i]->p_different < level;
        if (!by_statistics) continue;
        claims[i]->corrected = agrees[i] < level      ? Outcome::agree
                               : disagrees[i] < level ? Outcome::disagree
                                                      : Outcome::undecided;
    }
}

}  // namespace crossgrain::judge
