#include "reference/compare/equivalence.hpp"

#include "reference/compare/student.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::compare {
namespace {

void check(const EquivalenceQuestion& q) {
    const bool finite = std::isfinite(q.difference) && std::isfinite(q.standard_error) &&
                        std::isfinite(q.margin) && !std::isnan(q.degrees_of_freedom);
    const bool in_range = q.standard_error >= 0 && q.degrees_of_freedom >= 0 &&
                          (q.margin > 0 || (q.margin == 0 && q.standard_error == 0));
    if (finite && in_range) return;
    throw std::invalid_argument(fmt::format(
        "no equivalence test for difference {}, standard error {} ({} degrees of freedom), "
        "margin {}",
        q.difference, q.standard_error, q.degrees_of_freedom, q.margin));
}

std::string beyond(double distance, double margin) {
    return fmt::format("difference {:.3g} exceeds the margin {:.3g}", distance, margin);
}

// Without scatter there is nothing to test: the numbers are compared.
EquivalenceAnswer compare_exact(double distance, double margin) {
    if (distance <= margin) return {.outcome = Outcome::agree, .reason = {}};
    return {.outcome = Outcome::disagree, .reason = beyond(distance, margin)};
}

std::string what_would_decide(const EquivalenceQuestion& q, const EquivalenceAnswer& answer) {
    if (std::isinf(answer.samples_factor)) {
        return "the difference equals the margin: no number of samples would decide";
    }
    std::string text =
        fmt::format("difference {:.3g} +- {:.3g} (95 %) against margin {:.3g}: ", q.difference,
                    answer.half_width_95, q.margin);
    text += fmt::format("about {:.1f} times as many samples", answer.samples_factor);
    if (std::isfinite(q.degrees_of_freedom)) {
        const double samples = std::ceil(answer.samples_factor * (q.degrees_of_freedom + 1));
        text += fmt::format(" ({:.0f} instead of {:.0f})", samples, q.degrees_of_freedom + 1);
    }
    return text + " would decide if the difference stays";
}

/// Of the sum of two errors; of the only one, if the other number is exact.
double joint_degrees_of_freedom(const Operand& a, const Operand& b) {
    if (b.standard_error == 0) return a.degrees_of_freedom;
    if (a.standard_error == 0) return b.degrees_of_freedom;
    if (!(a.degrees_of_freedom > 0 && b.degrees_of_freedom > 0)) return 0;
    return welch_degrees_of_freedom(a.standard_error, a.degrees_of_freedom, b.standard_error,
                                    b.degrees_of_freedom);
}

}  // namespace

Operand quotient_of(const Operand& a, const Operand& b) {
    const double value = a.value / b.value;
    return {.value = value,
            .standard_error =
                std::hypot(a.standard_error, value * b.standard_error) / std::abs(b.value),
            .degrees_of_freedom = std::min(a.degrees_of_freedom, b.degrees_of_freedom)};
}

EquivalenceQuestion question_of(const Operand& a, const Operand& b, double margin) {
    return {.difference = a.value - b.value,
            .standard_error = std::hypot(a.standard_error, b.standard_error),
            .degrees_of_freedom = joint_degrees_of_freedom(a, b),
            .margin = margin};
}

EquivalenceAnswer equivalence(const EquivalenceQuestion& q) {
    check(q);
    const double distance = std::abs(q.difference);
    if (q.standard_error == 0) return compare_exact(distance, q.margin);

    EquivalenceAnswer answer;
    if (q.degrees_of_freedom < 1) {
        answer.half_width_90 = answer.half_width_95 = std::numeric_limits<double>::infinity();
        answer.reason = "a single sample has no error that could be trusted: run more replicas";
        answer.samples_factor = 2;
        return answer;
    }
    answer.half_width_90 = student_quantile(0.95, q.degrees_of_freedom) * q.standard_error;
    answer.half_width_95 = student_quantile(0.975, q.degrees_of_freedom) * q.standard_error;
    if (distance + answer.half_width_90 < q.margin) {
        answer.outcome = Outcome::agree;
        return answer;
    }
    if (distance - answer.half_width_95 > q.margin) {
        answer.outcome = Outcome::disagree;
        answer.reason = fmt::format("{} by more than its 95 % half-width {:.3g}",
                                    beyond(distance, q.margin), answer.half_width_95);
        return answer;
    }
    // The half-width that would do is the distance to the margin; errors fall as 1/sqrt(samples).
    const double width = distance < q.margin ? answer.half_width_90 : answer.half_width_95;
    const double room = std::abs(q.margin - distance);
    answer.samples_factor =
        room == 0 ? std::numeric_limits<double>::infinity() : width / room * (width / room);
    answer.reason = what_would_decide(q, answer);
    return answer;
}

}  // namespace crossgrain::compare
