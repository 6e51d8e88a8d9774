// Exponents of synthetic power laws: the interval must hold the exponent put in as often as it
// says.
#include "reference/compare/bootstrap.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain::compare;

namespace {

std::vector<FittedPoint> power_law(double exponent, double scatter, std::size_t count,
                                   std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<FittedPoint> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = std::pow(2.0, static_cast<double>(i) / 4);
        points.push_back({x, 3 * std::pow(x, exponent) * std::exp(scatter * normal(random))});
    }
    return points;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_exponent_of_an_exact_law_is_exact) {
    const auto points = power_law(-5.0 / 3, 0, 12, 1);
    BOOST_TEST(power_law_exponent(points) == -5.0 / 3, tt::tolerance(1e-12));
    BOOST_TEST(bootstrap(points, power_law_exponent).standard_error < 1e-12);
}

// 400 synthetic data sets: 95 % +- 2.1 % (two standard deviations of the count).
BOOST_AUTO_TEST_CASE(the_interval_covers_the_exponent) {
    constexpr int trials = 400;
    int covered = 0;
    for (int i = 0; i < trials; ++i) {
        const auto points = power_law(-1.4, 0.3, 40, static_cast<std::uint64_t>(100 + i));
        const auto found = bootstrap(points, power_law_exponent, 200);
        covered += found.low <= -1.4 && -1.4 <= found.high ? 1 : 0;
    }
    BOOST_TEST(covered >= 0.93 * trials);
    BOOST_TEST(covered <= 0.975 * trials);
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_error) {
    const auto points = power_law(2, 0.2, 20, 5);
    BOOST_TEST(bootstrap(points, power_law_exponent, 200, 3).standard_error ==
               bootstrap(points, power_law_exponent, 200, 3).standard_error);
}

BOOST_AUTO_TEST_CASE(windows_show_a_law_that_bends) {
    const std::array<FitWindow, 3> windows{{{1, 8}, {8, 64}, {1, 64}}};
    const auto straight = power_law(-1.5, 0, 25, 1);
    BOOST_TEST(systematic_over_windows(straight, power_law_exponent, windows) < 1e-12);
    // y = x^-1 below 8, x^-2 above: the windows find -1, -2 and something between.
    std::vector<FittedPoint> bent;
    for (const auto& p : straight)
        bent.push_back({p.x, p.x < 8 ? 8 / p.x : 64 / (p.x * p.x)});
    BOOST_TEST(systematic_over_windows(bent, power_law_exponent, windows) == 0.5,
               tt::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(too_little_is_refused) {
    const auto points = power_law(1, 0.1, 3, 1);
    BOOST_CHECK_THROW((void)bootstrap(points, power_law_exponent), std::invalid_argument);
    const auto enough = power_law(1, 0.1, 8, 1);
    BOOST_CHECK_THROW((void)bootstrap(enough, power_law_exponent, 10), std::invalid_argument);
    const auto nothing = [](std::span<const FittedPoint>) {
        return std::numeric_limits<double>::quiet_NaN();
    };
    BOOST_CHECK_THROW((void)bootstrap(enough, nothing), std::invalid_argument);
    const std::array<FitWindow, 2> empty{{{100, 200}, {200, 300}}};
    BOOST_CHECK_THROW((void)systematic_over_windows(enough, power_law_exponent, empty),
                      std::invalid_argument);
}
