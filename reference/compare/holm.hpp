// Correction for many verdicts in one report (Holm, Scand. J. Statist. 6, 65 (1979)).
//
// With p-values p_(1) <= ... <= p_(n) the adjusted ones are
//   q_(i) = max over j <= i of min(1, (n - j + 1) p_(j)).
// Claiming only what has q <= alpha keeps the probability of one false claim or more among all n
// below alpha, whatever the dependence between them (family-wise error).
#pragma once

#include <span>
#include <vector>

namespace crossgrain::compare {

/// Adjusted p-values in the order given. Throws std::invalid_argument for one outside [0, 1].
[[nodiscard]] std::vector<double> holm(std::span<const double> p_values);

}  // namespace crossgrain::compare
