// P-values must say what the verdict says, and the number of samples must be the first that
// decides.
#include "reference/compare/equivalence_power.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <random>

namespace tt = boost::test_tools;
using namespace crossgrain::compare;

namespace {
constexpr double infinite = std::numeric_limits<double>::infinity();
}

BOOST_AUTO_TEST_CASE(p_values_and_verdicts_agree) {
    for (const double difference : {-3.0, -1.2, -0.4, 0.0, 0.3, 0.8, 1.0, 1.7, 4.0}) {
        for (const double error : {0.05, 0.3, 0.6, 1.0}) {
            for (const double dof : {1.0, 3.0, 20.0, infinite}) {
                const EquivalenceQuestion q{difference, error, dof, 1.0};
                const auto p = equivalence_p_values(q);
                const auto outcome = equivalence(q).outcome;
                BOOST_TEST((p.equivalent < 0.05) == (outcome == Outcome::agree));
                BOOST_TEST((p.different < 0.05) == (outcome == Outcome::disagree));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(known_p_values) {
    // (1 - 0.2)/0.5 = 1.6 standard errors of a normal: Q(1.6) = 0.0547993.
    const auto p = equivalence_p_values({0.2, 0.5, infinite, 1.0});
    BOOST_TEST(p.equivalent == 0.0547993, tt::tolerance(1e-5));
    BOOST_TEST(p.different == 1);
    const auto exact = equivalence_p_values({2.0, 0, infinite, 1.0});
    BOOST_TEST(exact.equivalent == 1);
    BOOST_TEST(exact.different == 0);
    BOOST_TEST(equivalence_p_values({0, 1.0, 0, 1.0}).equivalent == 1);
}

BOOST_AUTO_TEST_CASE(the_number_of_replicas_is_the_smallest_that_decides) {
    for (const double difference : {0.0, 0.5, 1.6}) {
        // Two codes with six replicas each: ten degrees of freedom.
        const EquivalenceQuestion q{difference, 0.6, 10, 1.0};
        const auto more = replicas_needed(q, 6);
        BOOST_REQUIRE(more.has_value());
        const auto decided = [&](std::int64_t added) {
            EquivalenceQuestion larger = q;
            larger.standard_error *= std::sqrt(6.0 / static_cast<double>(6 + added));
            larger.degrees_of_freedom = static_cast<double>(10 + 2 * added);
            return equivalence(larger).outcome != Outcome::undecided;
        };
        BOOST_TEST(decided(*more));
        BOOST_TEST(!decided(*more - 1));
    }
}

// The promise: with that many replicas most repetitions decide, with half of them few do.
BOOST_AUTO_TEST_CASE(so_many_replicas_do_decide) {
    const EquivalenceQuestion q{0.3, 0.9, 7, 1.0};  // eight replicas of scatter 0.9 sqrt(8)
    const auto more = replicas_needed(q, 8);
    BOOST_REQUIRE(more.has_value());
    std::mt19937_64 random(5);
    std::normal_distribution<double> replica(0.3, 0.9 * std::sqrt(8.0));
    const auto share_decided = [&](std::int64_t n) {
        int decided = 0;
        for (int trial = 0; trial < 1000; ++trial) {
            double sum = 0, squares = 0;
            for (std::int64_t i = 0; i < n; ++i) {
                const double value = replica(random);
                sum += value;
                squares += value * value;
            }
            const auto count = static_cast<double>(n);
            const double variance = (squares - sum * sum / count) / (count - 1);
            const auto answer =
                equivalence({sum / count, std::sqrt(variance / count), count - 1, 1.0});
            decided += answer.outcome == Outcome::undecided ? 0 : 1;
        }
        return decided / 1000.0;
    };
    BOOST_TEST(share_decided(8 + *more) > 0.4);  // half of the differences come out larger
    BOOST_TEST(share_decided(2 * (8 + *more)) > 0.7);
    BOOST_TEST(share_decided((8 + *more) / 2) < 0.35);
}

BOOST_AUTO_TEST_CASE(no_number_where_none_helps_or_none_is_needed) {
    BOOST_TEST(!replicas_needed({0, 0.01, 10, 1.0}, 6));       // decided already
    BOOST_TEST(!replicas_needed({1.0, 0.5, 10, 1.0}, 6));      // at the margin
    BOOST_TEST(!replicas_needed({0, 1.0, 0, 1.0}, 1));         // says nothing of scatter
    BOOST_TEST(!replicas_needed({0.5, 0, infinite, 1.0}, 1));  // a number without scatter
}
