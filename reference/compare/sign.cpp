#include "reference/compare/sign.hpp"

#include "reference/compare/student.hpp"

#include <algorithm>
#include <cmath>

namespace crossgrain::compare {
namespace {

/// -1, 0 or 1: 0 if the sign is not certain at the 5 % level.
int certain_sign(const Operand& number) {
    const double dof = std::max(1.0, number.degrees_of_freedom);
    const double least =
        number.standard_error > 0 ? student_quantile(0.975, dof) * number.standard_error : 0;
    if (std::abs(number.value) <= least) return 0;
    return number.value > 0 ? 1 : -1;
}

}  // namespace

SignAnswer judge_sign(const Operand& a, const Operand& b) {
    const int of_a = certain_sign(a), of_b = certain_sign(b);
    if (of_a == 0 || of_b == 0) return {Outcome::undecided, "a sign is not certain"};
    return {of_a == of_b ? Outcome::agree : Outcome::disagree, ""};
}

}  // namespace crossgrain::compare
