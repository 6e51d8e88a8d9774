// Weighted line fit: exact lines, covariance against the scatter of synthetic fits, bad input.
#include "native/base/random.hpp"
#include "native/numerics/line_fit.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::numerics;
using Numbers = std::vector<double>;

BOOST_AUTO_TEST_CASE(finds_an_exact_line_whatever_the_weights) {
    const Numbers x{1, 2, 4, 7}, errors{0.1, 3, 0.5, 1};
    Numbers y;
    for (const double value : x)
        y.push_back(2 - 0.75 * value);
    for (const auto& fit : {fit_line(x, y, errors), fit_line(x, y)}) {
        // A few roundings.
        BOOST_TEST(fit.intercept == 2, tt::tolerance(1e-13));
        BOOST_TEST(fit.slope == -0.75, tt::tolerance(1e-13));
        BOOST_TEST(fit.at(10) == -5.5, tt::tolerance(1e-13));
        BOOST_TEST(fit.chi_squared < 1e-24);
        BOOST_TEST(fit.degrees_of_freedom == 2);
    }
}

BOOST_AUTO_TEST_CASE(two_points_carry_their_errors) {
    const auto fit = fit_line(Numbers{0, 2}, Numbers{1, 5}, Numbers{0.3, 0.4});
    BOOST_TEST(fit.intercept_error() == 0.3, tt::tolerance(1e-14));
    BOOST_TEST(fit.slope_error() == 0.25, tt::tolerance(1e-14));  // hypot(0.3, 0.4)/2
    BOOST_TEST(fit.error_at(2) == 0.4, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(stated_errors_are_the_scatter_of_repeated_fits) {
    const Numbers x{0.1, 0.2, 0.5, 1, 2}, errors{0.3, 0.1, 0.2, 0.4, 0.1};
    constexpr std::uint64_t repeats = 20000;
    double a = 0, aa = 0, b = 0, bb = 0, ab = 0, chi = 0;
    LineFit fit;
    for (std::uint64_t r = 0; r < repeats; ++r) {
        Numbers y;
        for (std::uint64_t i = 0; i < x.size(); ++i) {
            const double noise = normal_pair(5, RandomStream::jitter, r * x.size() + i)[0];
            y.push_back(1 + 3 * x[i] + errors[i] * noise);
        }
        fit = fit_line(x, y, errors);
        const double da = fit.intercept - 1, db = fit.slope - 3;
        a += da / repeats, aa += da * da / repeats;
        b += db / repeats, bb += db * db / repeats;
        ab += da * db / repeats, chi += fit.chi_squared / repeats;
    }
    // 20000 repeats know a variance to 1 %, a mean to 0.7 % of the error: five of those.
    BOOST_TEST(std::abs(a) < 0.035 * fit.intercept_error());
    BOOST_TEST(std::abs(b) < 0.035 * fit.slope_error());
    BOOST_TEST(aa == fit.intercept_variance, tt::tolerance(0.05));
    BOOST_TEST(bb == fit.slope_variance, tt::tolerance(0.05));
    BOOST_TEST(ab == fit.covariance, tt::tolerance(0.05));
    BOOST_TEST(chi == fit.degrees_of_freedom, tt::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(unknown_errors_are_taken_from_the_residuals) {
    const auto fit = fit_line(Numbers{-1, 0, 1}, Numbers{0, 3, 0});
    // Residuals -1, 2, -1: variance 6/1; slope variance 6/2, intercept variance 6/3.
    BOOST_TEST(fit.slope_variance == 3, tt::tolerance(1e-14));
    BOOST_TEST(fit.intercept_variance == 2, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(refuses_bad_points) {
    const auto refuse = [](const Numbers& x, const Numbers& y, const Numbers& errors) {
        BOOST_CHECK_THROW(static_cast<void>(fit_line(x, y, errors)), std::invalid_argument);
    };
    refuse({1}, {1}, {1});
    refuse({1, 2}, {1}, {1, 1});
    refuse({1, 1}, {1, 2}, {1, 1});
    refuse({1, 2}, {1, 2}, {1, 0});
    refuse({1, 2}, {1, 2}, {1, -1});
    refuse({1, std::nan("")}, {1, 2}, {1, 1});
    refuse({1, 2}, {1, std::nan("")}, {1, 1});
    BOOST_CHECK_THROW(static_cast<void>(fit_line(Numbers{1, 2}, Numbers{1, 2})),
                      std::invalid_argument);
}
