// Who is to blame: from the verdicts that turned bad to one code, or to the reference.
#pragma once

#include "reference/compare/verdict.hpp"

#include <optional>
#include <string>
#include <vector>

namespace crossgrain::selftest {

/// Verdicts that are not as expected now although they were before: those of `now` whose
/// counterpart in `before` (same code, observable, kind, reference and setting) was expected.
/// `undecided` is no objection: it says that nothing can be said.
[[nodiscard]] std::vector<compare::Verdict>
new_objections(const std::vector<compare::Verdict>& before,
               const std::vector<compare::Verdict>& now);

/// The code whose verdicts object most: its own against closed forms and published values, and
/// those of pairs it is part of. "published" if instead all of two codes or more object to the same
/// published values and to nothing else. Nothing if two codes are equally suspect: a pair that
/// disagrees does not tell which of the two is wrong.
[[nodiscard]] std::optional<std::string> culprit_of(const std::vector<compare::Verdict>& objections,
                                                    const std::vector<compare::Verdict>& all);

/// The objection that says most about this code: failed runs first, then closed forms, published
/// values, statistics and trajectories. `objections` must not be empty.
[[nodiscard]] const compare::Verdict& most_telling(const std::vector<compare::Verdict>& objections,
                                                   const std::optional<std::string>& culprit);

}  // namespace crossgrain::selftest
