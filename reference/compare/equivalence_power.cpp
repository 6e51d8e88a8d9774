#include "reference/compare/equivalence_power.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace crossgrain::compare {
namespace {

/// P(T >= t)
double upper_tail(double t, double degrees_of_freedom) {
    if (std::isinf(degrees_of_freedom)) {
        return boost::math::cdf(boost::math::complement(boost::math::normal(), t));
    }
    return boost::math::cdf(
        boost::math::complement(boost::math::students_t(degrees_of_freedom), t));
}

}  // namespace

EquivalencePValues equivalence_p_values(const EquivalenceQuestion& q) {
    const Outcome outcome = equivalence(q).outcome;  // checks the numbers
    if (q.standard_error == 0) {
        return outcome == Outcome::agree ? EquivalencePValues{0, 1} : EquivalencePValues{1, 0};
    }
    if (q.degrees_of_freedom < 1) return {};
    const double room = (q.margin - std::abs(q.difference)) / q.standard_error;
    return {.equivalent = upper_tail(room, q.degrees_of_freedom),
            .different = std::min(1.0, 2 * upper_tail(-room, q.degrees_of_freedom))};
}

std::optional<std::int64_t> replicas_needed(const EquivalenceQuestion& q, std::size_t replicas) {
    constexpr std::int64_t most = 1'000'000;
    const auto present = static_cast<double>(replicas);
    if (q.degrees_of_freedom < 1 || q.standard_error == 0 || present < 1) return std::nullopt;
    const auto decides = [&](std::int64_t more) {
        const double all = present + static_cast<double>(more);
        EquivalenceQuestion larger = q;
        larger.standard_error *= std::sqrt(present / all);
        larger.degrees_of_freedom *= present > 1 ? (all - 1) / (present - 1) : all;
        return equivalence(larger).outcome != Outcome::undecided;
    };
    if (decides(0) || !decides(most)) return std::nullopt;
    std::int64_t few = 0, enough = most;
    while (enough - few > 1) {
        const std::int64_t middle = (few + enough) / 2;
        (decides(middle) ? enough : few) = middle;
    }
    return enough;
}

void state_evidence(const EquivalenceQuestion& question, std::size_t replicas, Verdict& verdict) {
    const EquivalencePValues p = equivalence_p_values(question);
    verdict.p_equivalent = p.equivalent;
    verdict.p_different = p.different;
    verdict.more_replicas = replicas_needed(question, replicas);
}

}  // namespace crossgrain::compare
