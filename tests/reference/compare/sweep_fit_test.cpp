// Laws over the variants of a case: exact power laws and outlets, scatter, and points that cannot
// be fitted.
#include "reference/compare/sweep_fit.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

namespace tt = boost::test_tools;
using namespace crossgrain::compare;

namespace {

template <class Law>
std::vector<SweepPoint> points_of(std::vector<double> x, Law law, double scatter = 0) {
    std::vector<SweepPoint> points;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double sign = i % 2 == 0 ? 1 : -1;
        points.push_back({x[i], law(x[i]) * (1 + sign * scatter), scatter * law(x[i])});
    }
    return points;
}

const std::vector<double> outlets{8, 12, 16, 20, 28, 36};

}  // namespace

BOOST_AUTO_TEST_CASE(exponent_of_an_exact_power_law) {
    const auto fit = fit_exponent(points_of({1, 2, 5}, [](double x) { return 3 * x * x; }));
    BOOST_TEST(fit->value == 2.0, tt::tolerance(1e-12));
    BOOST_TEST(fit->standard_error < 1e-7);
    BOOST_TEST(fit->degrees_of_freedom == 1.0);
}

BOOST_AUTO_TEST_CASE(scatter_is_in_the_error) {
    const auto points = points_of(
        {10, 20, 30, 40, 60, 90}, [](double x) { return std::pow(x, 2.2); }, 0.05);
    const auto fit = fit_exponent(points);
    BOOST_TEST(std::abs(fit->value - 2.2) < 3 * fit->standard_error);
    BOOST_TEST(fit->standard_error > 0.02);
    // Points that happen to lie on a line are not better known than they are: ln 10, ln 20 and ln
    // 30 scatter by 0.617 about their mean.
    auto straight = points_of({10, 20, 30}, [](double x) { return x; });
    for (auto& p : straight)
        p.standard_error = 0.1 * p.y;
    BOOST_TEST(fit_exponent(straight)->standard_error == 0.1 / std::sqrt(0.617),
               tt::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(beverloo_is_found_again) {
    const auto beverloo = [](double d) { return 1.45 * std::pow(d - 1.8, 1.5); };
    const auto law = fit_outlet_law(points_of(outlets, beverloo));
    BOOST_TEST(law->factor.value == 1.45, tt::tolerance(1e-9));
    BOOST_TEST(law->cut.value == 1.8, tt::tolerance(1e-9));
    const auto free = fit_outlet_exponent(points_of(outlets, beverloo));
    BOOST_TEST(free->value == 1.5, tt::tolerance(1e-3));
    BOOST_TEST(free->standard_error < 1e-2);
}

BOOST_AUTO_TEST_CASE(rates_measured_in_hoppers_have_a_free_exponent_near_its_published_one) {
    // D and rate of the reference runs in a hopper of 60 degrees.
    std::vector<SweepPoint> points;
    const std::vector<double> rates{22.4, 46.6, 77.5, 113.8, 194, 270};
    for (std::size_t i = 0; i < outlets.size(); ++i)
        points.push_back({outlets[i], rates[i], 0.02 * rates[i]});
    const auto free = fit_outlet_exponent(points);
    BOOST_TEST_MESSAGE("n = " << free->value << " +- " << free->standard_error);
    BOOST_TEST(std::abs(free->value - 1.39) < 0.1);
    const auto law = fit_outlet_law(std::span(points).subspan(1, 4));
    BOOST_TEST_MESSAGE("C = " << law->factor.value << " +- " << law->factor.standard_error
                              << ", k = " << law->cut.value << " +- " << law->cut.standard_error);
    BOOST_TEST(law->factor.value == 1.45, tt::tolerance(0.05));
    BOOST_TEST(std::abs(law->cut.value - 1.8) < 0.3);
}

BOOST_AUTO_TEST_CASE(slopes_of_a_parabola_are_exact_at_uneven_points) {
    const auto slopes =
        local_slopes(points_of({0.05, 0.1, 0.2, 0.25}, [](double x) { return 8 * x - 6 * x * x; }));
    BOOST_TEST(!slopes.front());
    BOOST_TEST(!slopes.back());
    BOOST_TEST(slopes[1]->value == 8 - 1.2, tt::tolerance(1e-9));
    BOOST_TEST(slopes[2]->value == 8 - 2.4, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_fitted_is_not) {
    const auto line = [](double x) { return x; };
    BOOST_TEST(!fit_exponent(points_of({1, 2}, line)));
    BOOST_TEST(!fit_exponent(points_of({-1, 1, 2}, line)));
    BOOST_TEST(!fit_exponent(points_of({2, 2, 2}, line)));
    BOOST_TEST(!fit_outlet_law(points_of({1, 2, 3}, [](double x) { return 10 - x; })));
    BOOST_TEST(!fit_outlet_law(points_of({2, 2, 2}, line)));
    BOOST_TEST(!fit_outlet_exponent(points_of({1, 2, 3, 4}, line)));
}
