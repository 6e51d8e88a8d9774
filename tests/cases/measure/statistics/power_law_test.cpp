// Slopes of exact and of noisy power laws, and windows that have none.
#include "cases/measure/statistics/power_law.hpp"

#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;

namespace {

std::vector<double> power_law(double exponent) {
    std::vector<double> spectrum{0.0};
    for (int k = 1; k <= 32; ++k)
        spectrum.push_back(5 * std::pow(k, exponent));
    return spectrum;
}

// Exponentially distributed about the power law, as periodograms of Gaussian noise are.
std::vector<double> noisy(double exponent, std::uint64_t which) {
    auto spectrum = power_law(exponent);
    for (std::size_t k = 0; k < spectrum.size(); ++k) {
        spectrum[k] *= -std::log(uniform(4, RandomStream::jitter, which * 64 + k));
    }
    return spectrum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(exact_power_laws) {
    for (const double exponent : {-5.0 / 3, 0.0, 1.0}) {
        const auto slope = measure::log_log_slope(power_law(exponent), 1, 16);
        BOOST_TEST_REQUIRE(slope.has_value());
        BOOST_TEST(std::abs(*slope - exponent) < 1e-13);
    }
    BOOST_TEST(std::abs(*measure::log_log_slope(power_law(-2), 17, 32) + 2) < 1e-12);
}

BOOST_AUTO_TEST_CASE(error_is_the_scatter_of_repeated_spectra) {
    constexpr std::uint64_t repeats = 400, n = 20;
    double mean = 0, squares = 0, one = 0, two = 0;
    for (std::uint64_t r = 0; r < repeats; ++r) {
        std::vector<std::vector<double>> samples;
        for (std::uint64_t i = 0; i < n; ++i)
            samples.push_back(noisy(-5.0 / 3, r * n + i));
        const auto slope = measure::slope_of_mean(samples, 1, 16);
        BOOST_TEST_REQUIRE(slope.has_value());
        mean += slope->value / repeats;
        squares += std::pow(slope->value + 5.0 / 3, 2) / repeats;
        one += slope->standard_error / repeats;
        two += slope->standard_error_blocks_of_two / repeats;
    }
    const double scatter = std::sqrt(squares);
    BOOST_TEST_MESSAGE("jackknife/scatter: " << one / scatter << ", blocks of two "
                                             << two / scatter);
    // The scatter of 400 is known to 4 %; the jackknife is biased upwards by some per cent.
    BOOST_TEST(one == scatter, tt::tolerance(0.15));
    BOOST_TEST(two == scatter, tt::tolerance(0.15));
    BOOST_TEST(std::abs(mean + 5.0 / 3) < 4 * scatter / std::sqrt(repeats));
}

BOOST_AUTO_TEST_CASE(repeated_vectors_are_unmasked_by_blocks_of_two) {
    // Every spectrum twice: half as many independent samples, the error is sqrt(2) times larger.
    double one = 0, two = 0;
    for (std::uint64_t r = 0; r < 100; ++r) {
        std::vector<std::vector<double>> samples;
        for (std::uint64_t i = 0; i < 20; ++i) {
            samples.push_back(noisy(-1, 20 * r + i));
            samples.push_back(samples.back());
        }
        const auto slope = measure::slope_of_mean(samples, 1, 16);
        one += slope->standard_error;
        two += slope->standard_error_blocks_of_two;
    }
    BOOST_TEST(two / one == std::sqrt(2.0), tt::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(windows_without_a_slope) {
    const auto good = power_law(-1);
    BOOST_TEST(!measure::log_log_slope(good, 0, 16).has_value());
    BOOST_TEST(!measure::log_log_slope(good, 5, 5).has_value());
    BOOST_TEST(!measure::log_log_slope(good, 1, 33).has_value());
    auto empty = good;
    empty[7] = 0;
    BOOST_TEST(!measure::log_log_slope(empty, 1, 16).has_value());
    BOOST_TEST(measure::log_log_slope(empty, 8, 16).has_value());
    empty[7] = std::nan("");
    BOOST_TEST(!measure::log_log_slope(empty, 1, 16).has_value());
    const std::vector<std::vector<double>> two{good, good};
    BOOST_TEST(!measure::slope_of_mean(two, 1, 16).has_value());
    const std::vector<std::vector<double>> none;
    BOOST_TEST(!measure::slope_of_mean(none, 1, 16).has_value());
}
