// Holm's correction on a worked example, and its family-wise error on uniform p-values.
#include "reference/compare/holm.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain::compare;

BOOST_AUTO_TEST_CASE(worked_example) {
    const auto adjusted = holm(std::array{0.01, 0.04, 0.03, 0.005});
    const std::array expected{0.03, 0.06, 0.06, 0.02};
    for (std::size_t i = 0; i < expected.size(); ++i)
        BOOST_TEST(adjusted[i] == expected[i], tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(order_is_kept_and_one_is_the_most) {
    const auto adjusted = holm(std::array{0.6, 0.5, 0.9});
    for (const double q : adjusted)
        BOOST_TEST(q == 1);
    BOOST_TEST(holm({}).empty());
}

// With only true null hypotheses, any claim is false: the chance of one must be 5 %.
BOOST_AUTO_TEST_CASE(chance_of_any_false_claim_is_the_level) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> uniform;
    constexpr int reports = 4000;
    int with_claim = 0;
    for (int i = 0; i < reports; ++i) {
        std::array<double, 40> p{};
        std::ranges::generate(p, [&] { return uniform(random); });
        with_claim += std::ranges::min(holm(p)) <= 0.05 ? 1 : 0;
    }
    BOOST_TEST(with_claim > 0.04 * reports);
    BOOST_TEST(with_claim < 0.06 * reports);
}

BOOST_AUTO_TEST_CASE(nonsense_is_refused) {
    BOOST_CHECK_THROW((void)holm(std::array{0.1, 1.1}), std::invalid_argument);
    BOOST_CHECK_THROW((void)holm(std::array{-0.1}), std::invalid_argument);
    BOOST_CHECK_THROW((void)holm(std::array{std::numeric_limits<double>::quiet_NaN()}),
                      std::invalid_argument);
}
