// Time means of signals with a repeated part, a transient and noise of known size.
#include "cases/measure/statistics/time_mean.hpp"

#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;

namespace {

constexpr double period = 6;

struct Signal {
    std::vector<double> t, value;
};

// 20 + 5 cos(2 pi t/T), plus noise that is constant through each period, of unit variance; 1000 in
// the first two periods.
Signal driven(double interval, double end) {
    Signal signal;
    for (int i = 0; i * interval < end; ++i) {
        const double t = i * interval;
        const auto which = static_cast<std::uint64_t>(t / period + 1e-9);
        const double noise = normal_pair(1, RandomStream::jitter, which)[0];
        const double wave = 5 * std::cos(2 * std::numbers::pi / period * t);
        signal.t.push_back(t);
        signal.value.push_back(which < 2 ? 1000.0 : 20 + wave + noise);
    }
    return signal;
}

}  // namespace

BOOST_AUTO_TEST_CASE(only_what_differs_between_periods_is_an_error) {
    for (const double interval : {0.1, 0.01}) {
        const auto signal = driven(interval, 402 * period);
        const auto mean = measure::time_mean(signal.t, signal.value, 2 * period, period);
        BOOST_TEST_REQUIRE(mean.has_value());
        // 400 periods of unit variance, known to the noise of blocking.
        BOOST_TEST(mean->standard_error == 1 / std::sqrt(400.0), tt::tolerance(0.4));
        BOOST_TEST(std::abs(mean->value - 20) < 4 / std::sqrt(400.0));
        BOOST_TEST(mean->blocks <= 400U);
    }
}

BOOST_AUTO_TEST_CASE(an_incomplete_last_period_does_not_count) {
    const auto whole = driven(0.1, 42 * period);
    const auto more = driven(0.1, 42.4 * period);
    const auto a = measure::time_mean(whole.t, whole.value, 2 * period, period);
    const auto b = measure::time_mean(more.t, more.value, 2 * period, period);
    BOOST_TEST_REQUIRE((a && b));
    BOOST_TEST(a->value == b->value);
}

BOOST_AUTO_TEST_CASE(without_a_drive_every_sample_counts) {
    std::vector<double> t, value;
    for (int i = 0; i < 1000; ++i) {
        t.push_back(i);
        value.push_back(normal_pair(2, RandomStream::jitter, static_cast<std::uint64_t>(i))[0]);
    }
    const auto mean = measure::time_mean(t, value, 0, std::nullopt);
    BOOST_TEST_REQUIRE(mean.has_value());
    BOOST_TEST(mean->standard_error == 1 / std::sqrt(1000.0), tt::tolerance(0.4));
}

// Of 200 series with 40 correlated samples to each independent one, the 95 % interval may miss the
// true mean in 5 %: in more than 9 % once in 100 times.
BOOST_AUTO_TEST_CASE(intervals_of_a_slow_series_hold_the_mean) {
    constexpr int trials = 200, samples = 4000;
    constexpr double phi = 0.95;
    int misses = 0;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        std::vector<double> t, value;
        double x = normal_pair(trial, RandomStream::jitter, 0)[0];
        for (std::uint64_t i = 1; i <= samples; ++i) {
            x = phi * x + std::sqrt(1 - phi * phi) * normal_pair(trial, RandomStream::jitter, i)[0];
            t.push_back(static_cast<double>(i));
            value.push_back(x);
        }
        const auto mean = measure::time_mean(t, value, 0, std::nullopt);
        BOOST_TEST_REQUIRE(mean.has_value());
        misses += std::abs(mean->value) > 2 * mean->standard_error ? 1 : 0;
    }
    BOOST_TEST(misses <= 0.09 * trials);
}

BOOST_AUTO_TEST_CASE(too_few_periods_have_no_mean) {
    const auto signal = driven(0.1, 4.9 * period);
    BOOST_TEST(!measure::time_mean(signal.t, signal.value, 2 * period, period).has_value());
    BOOST_TEST(!measure::time_mean(signal.t, signal.value, 1e9, period).has_value());
    BOOST_TEST(!measure::time_mean({}, {}, 0, period).has_value());
}
