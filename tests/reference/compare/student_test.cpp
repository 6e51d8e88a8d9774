// Quantiles against printed tables and symmetry; Welch's degrees of freedom against its limits.
#include "reference/compare/student.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain::compare;

namespace {
const double infinite = std::numeric_limits<double>::infinity();
}

BOOST_AUTO_TEST_CASE(quantiles_of_the_printed_tables) {
    // Tables give four or more digits.
    const auto tolerance = tt::tolerance(5e-5);
    BOOST_TEST(student_quantile(0.975, 1) == 12.7062, tolerance);
    BOOST_TEST(student_quantile(0.975, 10) == 2.22814, tolerance);
    BOOST_TEST(student_quantile(0.95, 5) == 2.01505, tolerance);
    BOOST_TEST(student_quantile(0.975, infinite) == 1.95996, tolerance);
}

BOOST_AUTO_TEST_CASE(quantiles_of_closed_forms) {
    // One degree of freedom is the Cauchy distribution, two have t = (2p - 1)/sqrt(2p(1 - p)).
    for (const double p : {0.03, 0.4, 0.8, 0.99}) {
        BOOST_TEST(student_quantile(p, 1) == std::tan(3.14159265358979324 * (p - 0.5)),
                   tt::tolerance(1e-12));
        BOOST_TEST(student_quantile(p, 2) == (2 * p - 1) / std::sqrt(2 * p * (1 - p)),
                   tt::tolerance(1e-12));
        BOOST_TEST(student_quantile(p, 7.5) == -student_quantile(1 - p, 7.5), tt::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_CASE(rejects_impossible_probabilities_and_degrees_of_freedom) {
    for (const double p : {0.0, 1.0, -0.1, std::nan("")}) {
        BOOST_CHECK_THROW(static_cast<void>(student_quantile(p, 3)), std::domain_error);
    }
    BOOST_CHECK_THROW(static_cast<void>(student_quantile(0.9, 0)), std::domain_error);
    BOOST_CHECK_THROW(static_cast<void>(student_quantile(0.9, std::nan(""))), std::domain_error);
}

BOOST_AUTO_TEST_CASE(welch_limits) {
    // Equal errors of equal weight pool; an exact partner contributes nothing.
    BOOST_TEST(welch_degrees_of_freedom(0.1, 9, 0.1, 9) == 18, tt::tolerance(1e-14));
    BOOST_TEST(welch_degrees_of_freedom(0.1, 9, 0.0, 3) == 9, tt::tolerance(1e-14));
    BOOST_TEST(welch_degrees_of_freedom(0.1, 9, 0.0, infinite) == 9, tt::tolerance(1e-14));
    BOOST_TEST(welch_degrees_of_freedom(1e-200, 9, 1e-200, 9) == 18, tt::tolerance(1e-14));
    BOOST_TEST(std::isinf(welch_degrees_of_freedom(0, 9, 0, 9)));
    BOOST_TEST(std::isinf(welch_degrees_of_freedom(1, infinite, 2, infinite)));
    BOOST_CHECK_THROW(static_cast<void>(welch_degrees_of_freedom(-1, 9, 0, 9)), std::domain_error);
    BOOST_CHECK_THROW(static_cast<void>(welch_degrees_of_freedom(1, 0, 1, 9)), std::domain_error);
}
