// The exponent of a power law comes out exactly, whatever the window; what is no spectrum gives
// none.
#include "cases/measure/statistics/log_binned_slope.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <vector>

using namespace crossgrain;

namespace {

std::vector<double> power_law(double alpha, std::size_t points) {
    std::vector<double> power(points / 2 + 1, 1.0);
    for (std::size_t k = 1; k < power.size(); ++k)
        power[k] = 7.0 * std::pow(static_cast<double>(k), -alpha);
    return power;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_power_law_gives_its_exponent_over_every_window) {
    for (const double alpha : {-1.0, 0.0, 0.5, 1.33, 1.86}) {
        const auto power = power_law(alpha, 16384);
        for (const double high : {5e-3, 1e-2, 0.5}) {
            const auto slope = measure::log_binned_slope(power, 16384, {1e-3, high});
            BOOST_TEST_REQUIRE(slope.has_value());
            BOOST_TEST(std::abs(*slope + alpha) < 1e-10);
        }
    }
}

BOOST_AUTO_TEST_CASE(bins_weigh_the_same_however_many_frequencies_they_hold) {
    // Two laws that meet at f = .01: with equal weights for the bins the slope over two decades is
    // near the mean of the two, with equal weights for the frequencies near that of the upper.
    auto power = power_law(2.0, 16384);
    const double corner = power[164];
    for (std::size_t k = 165; k < power.size(); ++k)
        power[k] = corner;
    const auto slope = measure::log_binned_slope(power, 16384, {1e-3, 1e-1});
    BOOST_TEST_REQUIRE(slope.has_value());
    BOOST_TEST(*slope < -0.9);
    BOOST_TEST(*slope > -1.1);
}

BOOST_AUTO_TEST_CASE(only_the_window_counts) {
    auto power = power_law(1.0, 1024);
    power[5] = 1e9;
    power[400] = 0;
    const auto slope = measure::log_binned_slope(power, 1024, {1e-2, 1e-1});
    BOOST_TEST_REQUIRE(slope.has_value());
    BOOST_TEST(std::abs(*slope + 1) < 1e-10);
}

BOOST_AUTO_TEST_CASE(no_power_or_too_few_frequencies_give_no_slope) {
    auto power = power_law(1.0, 1024);
    BOOST_TEST(!measure::log_binned_slope(power, 1024, {1e-3, 2e-3}).has_value());
    BOOST_TEST(!measure::log_binned_slope(power, 1024, {0.4, 0.41}).has_value());
    power[50] = 0;
    BOOST_TEST(!measure::log_binned_slope(power, 1024, {1e-2, 1e-1}).has_value());
    power[50] = std::nan("");
    BOOST_TEST(!measure::log_binned_slope(power, 1024, {1e-2, 1e-1}).has_value());
}
