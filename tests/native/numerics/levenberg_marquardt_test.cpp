// Non-linear least squares on problems with known minima, at bounds, and on a wrong derivative.
#include "native/numerics/levenberg_marquardt.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain::numerics;

namespace {

/// (10 (y - x^2), 1 - x): minimum 0 at (1, 1), along a curved valley (Rosenbrock 1960).
void rosenbrock(std::span<const double> p, std::span<double> r, std::span<double> jacobian) {
    r[0] = 10 * (p[1] - p[0] * p[0]);
    r[1] = 1 - p[0];
    jacobian[0] = -20 * p[0];
    jacobian[1] = 10;
    jacobian[2] = -1;
    jacobian[3] = 0;
}

constexpr std::array times{0.0, 0.5, 1.0, 2.0, 4.0};
constexpr std::array heights{2.1, 1.5, 1.2, 0.6, 0.3};

/// a exp(-b t) - y with y off the curve.
void decay(std::span<const double> p, std::span<double> r, std::span<double> jacobian) {
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double e = std::exp(-p[1] * times[i]);
        r[i] = p[0] * e - heights[i];
        jacobian[2 * i] = e;
        jacobian[2 * i + 1] = -p[0] * times[i] * e;
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(follows_a_curved_valley) {
    const auto minimum = levenberg_marquardt(rosenbrock, 2, std::array{-1.2, 1.0});
    BOOST_TEST_REQUIRE(minimum.has_value());
    BOOST_TEST(minimum->parameters[0] == 1, tt::tolerance(1e-10));
    BOOST_TEST(minimum->parameters[1] == 1, tt::tolerance(1e-10));
}

// For a given b the best a is linear; the sum is then a function of b alone, scanned finely.
BOOST_AUTO_TEST_CASE(finds_the_minimum_that_a_scan_finds) {
    const auto squares = [](double b) {
        double ey = 0, ee = 0, yy = 0;
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double e = std::exp(-b * times[i]);
            ey += e * heights[i], ee += e * e, yy += heights[i] * heights[i];
        }
        return yy - ey * ey / ee;
    };
    double best = 0;
    for (double b = 0.1; b < 2; b += 1e-5)
        if (squares(b) < squares(best)) best = b;
    const auto minimum = levenberg_marquardt(decay, times.size(), std::array{1.0, 0.1});
    BOOST_TEST_REQUIRE(minimum.has_value());
    BOOST_TEST(std::abs(minimum->parameters[1] - best) < 2e-5);  // the scan's step
    BOOST_TEST(minimum->squares <= squares(best));
}

BOOST_AUTO_TEST_CASE(ends_on_a_bound_that_cuts_the_minimum_off) {
    const std::array bounds{ParameterBounds{0, 10}, ParameterBounds{0.8, 2}};
    const auto minimum = levenberg_marquardt(decay, times.size(), std::array{1.0, 1.0}, bounds);
    BOOST_TEST_REQUIRE(minimum.has_value());
    BOOST_TEST(minimum->parameters[1] == 0.8);
    // a is the best one there.
    double ey = 0, ee = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double e = std::exp(-0.8 * times[i]);
        ey += e * heights[i], ee += e * e;
    }
    BOOST_TEST(minimum->parameters[0] == ey / ee, tt::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(a_derivative_of_the_wrong_sign_reaches_no_minimum) {
    const auto wrong = [](std::span<const double> p, std::span<double> r, std::span<double> j) {
        decay(p, r, j);
        for (double& d : j)
            d = -d;
    };
    BOOST_TEST(!levenberg_marquardt(wrong, times.size(), std::array{1.0, 0.1}).has_value());
}

BOOST_AUTO_TEST_CASE(refuses_bad_input) {
    const std::array start{1.0, 1.0};
    const auto refuse = [&](std::size_t residuals, std::span<const double> from,
                            std::span<const ParameterBounds> bounds) {
        BOOST_CHECK_THROW((void)levenberg_marquardt(decay, residuals, from, bounds),
                          std::invalid_argument);
    };
    refuse(5, {}, {});
    refuse(1, start, {});
    refuse(5, start, std::array{ParameterBounds{0, 2}});
    refuse(5, start, std::array{ParameterBounds{0, 2}, ParameterBounds{2, 3}});
    refuse(5, std::array{std::nan(""), 1.0}, {});
}
