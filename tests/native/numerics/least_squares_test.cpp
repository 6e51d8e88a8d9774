// Linear least squares: against the straight line, exact parabolas, stated errors, bad input.
#include "native/numerics/least_squares.hpp"

#include "native/base/random.hpp"
#include "native/numerics/line_fit.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::numerics;
using Numbers = std::vector<double>;

BOOST_AUTO_TEST_CASE(is_the_straight_line_where_that_is_fitted) {
    const Numbers x{0.1, 0.2, 0.5, 1, 2}, y{1.2, 1.7, 2.4, 4.1, 6.8}, errors{0.3, 0.1, 0.2, 0.4, 1};
    Numbers design;
    for (const double value : x)
        design.insert(design.end(), {1, value});
    const auto fit = fit_linear(design, 2, y, errors);
    const auto line = fit_line(x, y, errors);
    // Two algorithms on a well-conditioned problem: some roundings.
    BOOST_TEST(fit.coefficients[0] == line.intercept, tt::tolerance(1e-12));
    BOOST_TEST(fit.coefficients[1] == line.slope, tt::tolerance(1e-12));
    BOOST_TEST(fit.covariance_of(0, 0) == line.intercept_variance, tt::tolerance(1e-12));
    BOOST_TEST(fit.covariance_of(0, 1) == line.covariance, tt::tolerance(1e-12));
    BOOST_TEST(fit.covariance_of(1, 1) == line.slope_variance, tt::tolerance(1e-12));
    BOOST_TEST(fit.chi_squared == line.chi_squared, tt::tolerance(1e-12));
    BOOST_TEST(fit.degrees_of_freedom == 3);
}

// Powers up to the fifth on 1..2: condition about 1e6, which the normal equations would square.
BOOST_AUTO_TEST_CASE(an_ill_conditioned_polynomial_keeps_its_digits) {
    const Numbers wanted{1, -2, 3, -4, 5, -6};
    Numbers design, y;
    for (int i = 0; i <= 20; ++i) {
        const double x = 1 + i / 20.0;
        double sum = 0;
        for (std::size_t j = 0; j < wanted.size(); ++j) {
            design.push_back(std::pow(x, j));
            sum += wanted[j] * design.back();
        }
        y.push_back(sum);
    }
    const auto fit = fit_linear(design, wanted.size(), y, Numbers(y.size(), 1.0));
    for (std::size_t j = 0; j < wanted.size(); ++j)
        BOOST_TEST(fit.coefficients[j] == wanted[j], tt::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(the_covariance_is_the_scatter_of_repeated_fits) {
    const Numbers errors{0.3, 0.1, 0.2, 0.4, 0.1, 0.2};
    Numbers design;
    for (int i = 0; i < 6; ++i)
        design.insert(design.end(), {1, i - 2.0, (i - 2.0) * (i - 2.0)});
    constexpr std::uint64_t repeats = 20000;
    double aa = 0, cc = 0, ac = 0;
    LeastSquaresFit fit;
    for (std::uint64_t r = 0; r < repeats; ++r) {
        Numbers y;
        for (std::uint64_t i = 0; i < errors.size(); ++i)
            y.push_back(errors[i] * normal_pair(5, RandomStream::jitter, r * 6 + i)[0]);
        fit = fit_linear(design, 3, y, errors);
        aa += fit.coefficients[0] * fit.coefficients[0] / repeats;
        cc += fit.coefficients[2] * fit.coefficients[2] / repeats;
        ac += fit.coefficients[0] * fit.coefficients[2] / repeats;
    }
    // 20000 repeats know a variance to 1 %: five of those.
    BOOST_TEST(aa == fit.covariance_of(0, 0), tt::tolerance(0.05));
    BOOST_TEST(cc == fit.covariance_of(2, 2), tt::tolerance(0.05));
    BOOST_TEST(ac == fit.covariance_of(0, 2), tt::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(refuses_what_has_no_answer) {
    const auto refuse = [](const Numbers& design, std::size_t columns, const Numbers& y,
                           const Numbers& errors) {
        BOOST_CHECK_THROW((void)fit_linear(design, columns, y, errors), std::invalid_argument);
    };
    refuse({1, 2, 1, 2, 1, 2}, 2, {1, 2, 3}, {1, 1, 1});  // dependent columns
    refuse({1, 2}, 2, {1}, {1});                          // fewer rows than columns
    refuse({1, 2, 3}, 1, {1, 2}, {1, 1});
    refuse({1, 2}, 0, {1, 2}, {1, 1});
    refuse({1, 2}, 1, {1, 2}, {1, 0});
    refuse({1, std::nan("")}, 1, {1, 2}, {1, 1});
    refuse({1, 2}, 1, {1, std::numeric_limits<double>::infinity()}, {1, 1});
}
