// A difference between two settings that differ in several switches, split into what each switch
// makes of it. Turning one switch after the other from A to B, a switch makes
// v(S + i) - v(S) when the switches S are already turned; its contribution is the mean of that over
// all orders in which the switches can be turned (Shapley, in Contributions to the Theory of Games
// II, Ann. Math. Studies 28, 307 (1953)),
//
//   phi_i = sum_{S without i} |S|! (n - |S| - 1)!/n! (v(S + i) - v(S)),   sum_i phi_i = v(all) -
//   v(0).
#pragma once

#include "native/numerics/mean_with_error.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace crossgrain::compare {

/// What one switch makes of the difference, B minus A.
struct Contribution {
    numerics::MeanWithError average;  ///< phi_i, over all orders
    numerics::MeanWithError first;    ///< turned first: alone in A
    numerics::MeanWithError last;     ///< turned last: all others are already those of B
    /// Whether phi_i differs from 0 at 95 %, corrected for the number of switches (Bonferroni).
    bool significant = false;
};

struct Attribution {
    numerics::MeanWithError a, b;
    numerics::MeanWithError difference;       ///< b - a, the sum of the contributions' averages
    bool significant = false;                 ///< whether it differs from 0 at 95 %
    std::vector<Contribution> contributions;  ///< shape (switches)
    /// Difference minus the sum of `first`: what the switches make together beyond what each makes
    /// alone in A. The averages share it out, a pair's in halves.
    numerics::MeanWithError interaction;
};

/// Most switches that are attributed: their settings double with each.
inline constexpr std::size_t most_switches = 10;

/// `values`: shape (2^switches, replicas); bit i of the first index tells that switch i is turned,
/// 0 is A and the last is B. Replica r has the same seed in all settings, so that errors are those
/// of the differences by replica.
/// Throws std::invalid_argument unless there are 2^n settings with 0 < n <= most_switches, each
/// with the same number of replicas, two or more, all finite.
[[nodiscard]] Attribution attribute(std::span<const std::vector<double>> values);

}  // namespace crossgrain::compare
