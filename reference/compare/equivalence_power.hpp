// P-values of the two claims of an equivalence test, and how many samples would decide it.
#pragma once

#include "reference/compare/equivalence.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace crossgrain::compare {

/// With T of Student's distribution, |D| the distance, s its standard error, M the margin:
///   equivalent  P(T >= (M - |D|)/s): the larger of the two one-sided p-values, against
///               "the true difference is beyond the margin"; `agree` claims it at 5 %;
///   different   2 P(T >= (|D| - M)/s), at most 1: against "the true difference is within the
///               margin"; `disagree` claims it at 5 %.
/// Numbers without scatter (s = 0) have p-values 0 and 1.
struct EquivalencePValues {
    double equivalent = 1;
    double different = 1;
};
[[nodiscard]] EquivalencePValues equivalence_p_values(const EquivalenceQuestion& question);

/// How many replicas would have to be added, to each of the samples compared, for a verdict, if
/// difference and scatter stay as they are: the smallest number at which `equivalence` decides.
/// Errors fall as 1/sqrt(replicas), degrees of freedom grow as replicas - 1 (as replicas, if the
/// error is that within one run). Nothing if the present ones decide, if the error is not known, or
/// if no number up to a million would do. `replicas` >= 1.
[[nodiscard]] std::optional<std::int64_t> replicas_needed(const EquivalenceQuestion& question,
                                                          std::size_t replicas);

/// Writes p-values and, if undecided, the number of replicas into a verdict.
void state_evidence(const EquivalenceQuestion& question, std::size_t replicas, Verdict& verdict);

}  // namespace crossgrain::compare
