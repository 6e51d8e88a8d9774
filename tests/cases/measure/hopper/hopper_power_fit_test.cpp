// Power laws with a known exponent, and what each fit weighs.
#include "cases/measure/hopper/hopper_power_fit.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain::measure;

namespace {

std::vector<double> angles() {
    std::vector<double> x;
    for (int i = 0; i <= 770; ++i)
        x.push_back(13 + 0.1 * i);
    return x;
}

template <class Law>
std::vector<double> values(const std::vector<double>& x, Law law) {
    std::vector<double> y;
    for (const double value : x)
        y.push_back(law(value));
    return y;
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_fits_find_an_exact_power_law) {
    const auto x = angles();
    for (const double a : {-3.0, 0.0, 1.1, 2.56}) {
        const auto y = values(x, [a](double v) { return 0.003 * std::pow(v, a); });
        for (const auto& fit : {fit_logarithms(x, y), fit_unweighted(x, y)}) {
            BOOST_TEST_REQUIRE(fit.has_value());
            // Brent's method finds a minimum to the root of the machine precision.
            BOOST_TEST(std::abs(fit->exponent - a) < 1e-6);
            BOOST_TEST(fit->amplitude == 0.003, tt::tolerance(1e-5));
        }
    }
}

// Why the definition of the fit matters: 1/P ~ tan^2(theta/2) has local exponents from 2.0 at small
// angles to 3.14 at 90 degrees, and the unweighted fit sees the large 1/P, that is large angles.
BOOST_AUTO_TEST_CASE(the_unweighted_fit_is_decided_by_the_large_values) {
    const auto x = angles();
    const auto y =
        values(x, [](double v) { return 20 * std::pow(std::tan(v * std::numbers::pi / 360), 2); });
    const double logarithms = fit_logarithms(x, y)->exponent;
    const double unweighted = fit_unweighted(x, y)->exponent;
    BOOST_TEST(logarithms > 2.1);
    BOOST_TEST(logarithms < 2.4);
    BOOST_TEST(unweighted > logarithms + 0.2);
    BOOST_TEST(unweighted < 3.14);
}

BOOST_AUTO_TEST_CASE(the_unweighted_fit_is_a_minimum_of_the_sum_of_squares) {
    const std::vector<double> x{1, 2, 3, 4, 5}, y{1.2, 3.1, 9.5, 14.0, 27.0};
    const auto fit = fit_unweighted(x, y);
    BOOST_TEST_REQUIRE(fit.has_value());
    const auto squares = [&](double a, double b) {
        double sum = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            sum += std::pow(y[i] - b * std::pow(x[i], a), 2);
        return sum;
    };
    const double least = squares(fit->exponent, fit->amplitude);
    for (const double d : {-1e-3, 1e-3}) {
        BOOST_TEST(squares(fit->exponent + d, fit->amplitude) > least);
        BOOST_TEST(squares(fit->exponent, fit->amplitude * (1 + d)) > least);
    }
}

BOOST_AUTO_TEST_CASE(what_has_no_power_law_is_refused) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const std::vector<double>& y :
         {std::vector<double>{1, 0, 2}, std::vector<double>{1, -1, 2},
          std::vector<double>{1, infinity, 2}, std::vector<double>{1, 2}}) {
        const std::vector<double> x{1, 2, 3};
        BOOST_TEST(!fit_logarithms(x, y).has_value());
        BOOST_TEST(!fit_unweighted(x, y).has_value());
    }
    const std::vector<double> same{2, 2, 2}, y{1, 2, 3};
    BOOST_TEST(!fit_logarithms(same, y).has_value());
    BOOST_TEST(!fit_unweighted(same, y).has_value());
}
