// Equivalence by two one-sided tests (Schuirmann, J. Pharmacokin. Biopharm. 15, 657 (1987)).
//
// A difference D with standard error s and nu degrees of freedom is compared with a margin M that
// was chosen beforehand:
//   agree      |D| + t_{0.95, nu} s < M    the 90 % interval lies inside (-M, M): both one-sided
//                                          tests reject non-equivalence at the 5 % level;
//   disagree   |D| - t_{0.975, nu} s > M   the 95 % interval lies outside [-M, M];
//   undecided  otherwise: not enough data.
// With s = 0 (numbers without scatter) this is |D| <= M. At a true difference of exactly M a false
// `agree` has probability at most 5 %, a false `disagree` 2.5 %.
#pragma once

#include "reference/compare/verdict.hpp"

#include <limits>
#include <string>

namespace crossgrain::compare {

struct EquivalenceQuestion {
    double difference = 0;
    double standard_error = 0;  ///< of the difference, >= 0
    double degrees_of_freedom = std::numeric_limits<double>::infinity();
    double margin = 0;  ///< > 0; >= 0 if standard_error is 0
};

/// One of the two numbers of a comparison; of a closed form only the value, of a published number
/// its value and error.
struct Operand {
    double value = 0;
    double standard_error = 0;
    double degrees_of_freedom = std::numeric_limits<double>::infinity();
};

/// a/b with the errors of both propagated to first order; they rest on the fewer degrees of
/// freedom. `b.value` is not 0.
[[nodiscard]] Operand quotient_of(const Operand& a, const Operand& b);

/// a - b with both errors and the degrees of freedom of their sum (Welch, Biometrika 34, 28
/// (1947)); none if an error rests on none.
[[nodiscard]] EquivalenceQuestion question_of(const Operand& a, const Operand& b, double margin);

struct EquivalenceAnswer {
    Outcome outcome = Outcome::undecided;  ///< agree, disagree or undecided
    double half_width_90 = 0;              ///< t_{0.95} s
    double half_width_95 = 0;              ///< t_{0.975} s
    double samples_factor = 1;  ///< times the present number of samples that would decide it, if
                                ///< the difference and the scatter stay; infinite if |D| = M
    std::string reason;         ///< one line for `undecided` and `disagree`, empty for `agree`
};

/// Throws std::invalid_argument for numbers that are not finite, negative errors or margins, a zero
/// margin with a non-zero error. Less than one degree of freedom is `undecided` unless the standard
/// error is 0.
[[nodiscard]] EquivalenceAnswer equivalence(const EquivalenceQuestion& question);

}  // namespace crossgrain::compare
