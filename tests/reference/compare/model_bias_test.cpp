// Bias and deviation put in must come out, and the interval must cover the bias put in.
#include "reference/compare/model_bias.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain::compare;

namespace {

/// Truths of all sizes, references with 5 % error, a model 10 % high with 8 % deviation.
std::vector<ModelComparison> sample(std::mt19937_64& random, std::size_t count) {
    std::normal_distribution<double> normal;
    std::vector<ModelComparison> all;
    for (std::size_t i = 0; i < count; ++i) {
        const double truth = std::exp(2 * normal(random));
        all.push_back({.model = 1.1 * truth * (1 + 0.08 * normal(random)),
                       .reference = truth * (1 + 0.05 * normal(random)),
                       .reference_relative_error = 0.05});
    }
    return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bias_and_deviation_come_out) {
    std::mt19937_64 random(3);
    const auto found = model_bias(sample(random, 20000));
    BOOST_TEST(found.bias == 1.1, tt::tolerance(2e-3));
    BOOST_TEST(found.relative_deviation == 0.08, tt::tolerance(0.03));
    BOOST_TEST(found.reference_relative_error == 0.05, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_interval_covers_the_bias) {
    std::mt19937_64 random(4);
    constexpr int trials = 4000;
    int covered = 0;
    for (int i = 0; i < trials; ++i) {
        const auto found = model_bias(sample(random, 12));
        covered += found.bias_low <= 1.1 && 1.1 <= found.bias_high ? 1 : 0;
    }
    BOOST_TEST(covered > 0.93 * trials);
    BOOST_TEST(covered < 0.97 * trials);
}

BOOST_AUTO_TEST_CASE(scatter_that_references_explain_is_not_the_model_s) {
    const std::array<ModelComparison, 3> all{
        {{1.00, 1.01, 0.05, 0}, {2.02, 2.00, 0.05, 0}, {3.00, 3.00, 0.05, 0}}};
    BOOST_TEST(model_bias(all).relative_deviation == 0);
    auto negative = all;
    for (auto& c : negative) {
        c.model = -c.model;
        c.reference = -c.reference;
    }
    BOOST_TEST(model_bias(negative).bias == model_bias(all).bias);
}

BOOST_AUTO_TEST_CASE(a_sign_or_a_zero_has_no_logarithm) {
    using Two = std::array<ModelComparison, 2>;
    BOOST_CHECK_THROW((void)model_bias(Two{{{1, 1}, {-1, 1}}}), std::invalid_argument);
    BOOST_CHECK_THROW((void)model_bias(Two{{{1, 1}, {1, 0}}}), std::invalid_argument);
    BOOST_CHECK_THROW((void)model_bias(Two{{{1, 1}, {0, 1}}}), std::invalid_argument);
    BOOST_CHECK_THROW((void)model_bias(std::array<ModelComparison, 1>{{{1, 1}}}),
                      std::invalid_argument);
}
