// Blocking against series whose error of the mean is known in closed form.
#include "cases/measure/statistics/blocking.hpp"

#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;

namespace {

// x_{i+1} = phi x_i + noise of unit variance, stationary from the start; the variance of its mean
// is 1/((1 - phi)^2 n) for n much longer than the correlation.
std::vector<double> autoregressive(double phi, std::size_t n, std::uint64_t which) {
    std::vector<double> series;
    double x = normal_pair(2, RandomStream::jitter, which << 32)[0] / std::sqrt(1 - phi * phi);
    for (std::size_t i = 0; i < n; ++i) {
        series.push_back(x);
        x = phi * x + normal_pair(2, RandomStream::jitter, (which << 32) + i + 1)[0];
    }
    return series;
}

}  // namespace

BOOST_AUTO_TEST_CASE(error_of_correlated_series_is_the_known_one) {
    for (const double phi : {0.0, 0.5, 0.9, 0.98}) {
        constexpr std::size_t n = 1 << 14;
        constexpr int repeats = 100;
        double stated = 0, squares = 0;
        for (std::uint64_t r = 0; r < repeats; ++r) {
            const auto mean = measure::blocked_mean(autoregressive(phi, n, r));
            BOOST_TEST_REQUIRE(mean.has_value());
            stated += mean->standard_error / repeats;
            squares += mean->value * mean->value / repeats;
        }
        const double exact = 1 / ((1 - phi) * std::sqrt(static_cast<double>(n)));
        BOOST_TEST_MESSAGE("phi " << phi << ": stated/exact " << stated / exact
                                  << ", scatter/exact " << std::sqrt(squares) / exact);
        // Blocks of finite length miss a little of the correlation: at most a tenth.
        BOOST_TEST(stated == exact, tt::tolerance(0.1));
        // 100 repeats know the scatter to 7 %: three of those.
        BOOST_TEST(std::sqrt(squares) == exact, tt::tolerance(0.21));
    }
}

BOOST_AUTO_TEST_CASE(error_of_short_series_is_not_much_too_small) {
    // Forty values, as many as a run has periods: six batches of six know 0.8 and 0.6 of
    // the variance of the mean at phi = 0.5 and 0.7.
    for (const double phi : {0.0, 0.5, 0.7}) {
        constexpr std::size_t n = 40;
        constexpr int repeats = 2000;
        double answers = 0, stated = 0, squares = 0;
        for (std::uint64_t r = 0; r < repeats; ++r) {
            const auto mean = measure::blocked_mean(autoregressive(phi, n, r));
            if (!mean) continue;
            answers += 1;
            stated += mean->standard_error * mean->standard_error;
            squares += mean->value * mean->value;
        }
        BOOST_TEST_MESSAGE("phi " << phi << ": answered " << answers / repeats
                                  << ", stated/true variance " << stated / squares);
        BOOST_TEST(stated / squares > 0.5);
        BOOST_TEST(stated / squares < 1.2);
        BOOST_TEST(answers / repeats > 0.9);
    }
}

BOOST_AUTO_TEST_CASE(oscillation_is_not_mistaken_for_noise) {
    // 64 periods of 100 samples: the mean is known far better than 1/sqrt(2 n).
    std::vector<double> series;
    for (int i = 0; i < 6400; ++i)
        series.push_back(std::cos(2 * std::numbers::pi / 100 * i));
    const auto mean = measure::blocked_mean(series);
    BOOST_TEST_REQUIRE(mean.has_value());
    BOOST_TEST(mean->standard_error < 0.02);
    BOOST_TEST(std::abs(mean->value) < 1e-12);
}

BOOST_AUTO_TEST_CASE(constant_series_is_exact) {
    const auto mean = measure::blocked_mean(std::vector<double>(100, 0.1));
    BOOST_TEST_REQUIRE(mean.has_value());
    BOOST_TEST(mean->value == 0.1);
    BOOST_TEST(mean->standard_error == 0);
}

BOOST_AUTO_TEST_CASE(refuses_too_few_values) {
    BOOST_TEST(!measure::blocked_mean({}).has_value());
    BOOST_TEST(!measure::blocked_mean(std::vector<double>(11, 1.0)).has_value());
}

BOOST_AUTO_TEST_CASE(claims_little_of_a_series_shorter_than_its_correlation) {
    // A drift: every block length looks more correlated than the last.
    std::vector<double> drift;
    for (int i = 0; i < 1000; ++i)
        drift.push_back(i);
    const auto mean = measure::blocked_mean(drift);
    BOOST_REQUIRE(mean.has_value());
    BOOST_TEST(mean->blocks == 2U);
    BOOST_TEST(mean->standard_error == 250.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(independent_batches_are_seldom_taken_for_a_drift) {
    constexpr int repeats = 5000;
    double answers = 0;
    for (std::uint64_t r = 0; r < repeats; ++r) {
        if (measure::blocked_mean(autoregressive(0, 12, r))->blocks > 2) answers += 1.0 / repeats;
    }
    BOOST_TEST_MESSAGE("answered " << answers);
    // 5000 repeats know the rate to 0.0015.
    BOOST_TEST(answers > 0.98);
    BOOST_TEST(answers < 0.99);
}
