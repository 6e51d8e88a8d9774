// Clopper-Pearson intervals against their closed forms, and their coverage.
#include "reference/compare/binomial.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain::compare;

BOOST_AUTO_TEST_CASE(none_and_all_have_closed_forms) {
    const auto none = proportion_interval(0, 200);
    BOOST_TEST(none.low == 0);
    BOOST_TEST(none.high == 1 - std::pow(0.025, 1.0 / 200), tt::tolerance(1e-9));
    const auto all = proportion_interval(40, 40);
    BOOST_TEST(all.low == std::pow(0.025, 1.0 / 40), tt::tolerance(1e-9));
    BOOST_TEST(all.high == 1);
}

BOOST_AUTO_TEST_CASE(tails_hold_a_fortieth_each) {
    // P(X >= 3 | n = 20, low) and P(X <= 3 | n = 20, high), summed directly.
    const auto interval = proportion_interval(3, 20);
    const auto at_most = [](int k, int n, double p) {
        double sum = 0, term = std::pow(1 - p, n);
        for (int i = 0; i <= k; ++i) {
            sum += term;
            term *= (n - i) * p / ((i + 1) * (1 - p));
        }
        return sum;
    };
    BOOST_TEST(1 - at_most(2, 20, interval.low) == 0.025, tt::tolerance(1e-6));
    BOOST_TEST(at_most(3, 20, interval.high) == 0.025, tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(the_true_share_is_covered_at_least_as_often_as_promised) {
    std::mt19937_64 random(7);
    std::binomial_distribution<std::size_t> draw(60, 0.03);
    constexpr int trials = 4000;
    int covered = 0;
    for (int i = 0; i < trials; ++i) {
        const auto interval = proportion_interval(draw(random), 60);
        covered += interval.low <= 0.03 && 0.03 <= interval.high ? 1 : 0;
    }
    BOOST_TEST(covered >= 0.95 * trials);
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
    BOOST_CHECK_THROW((void)proportion_interval(0, 0), std::invalid_argument);
    BOOST_CHECK_THROW((void)proportion_interval(3, 2), std::invalid_argument);
    BOOST_CHECK_THROW((void)proportion_interval(1, 2, 1.0), std::invalid_argument);
}
