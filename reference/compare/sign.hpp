// Whether two numbers lie on the same side of zero, by statistics.
#pragma once

#include "reference/compare/equivalence.hpp"

namespace crossgrain::compare {

struct SignAnswer {
    Outcome outcome = Outcome::undecided;  ///< agree, disagree or undecided
    std::string reason;                    ///< one line for `undecided`, else empty
};

/// agree, disagree: both are certain of their sign, |value| > t_{0.975} times the standard error,
/// and have the same or the other one. Less than one degree of freedom counts as one.
[[nodiscard]] SignAnswer judge_sign(const Operand& a, const Operand& b);

}  // namespace crossgrain::compare
