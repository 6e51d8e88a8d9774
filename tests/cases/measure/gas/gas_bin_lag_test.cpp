// Bins that show another instant than their neighbours are found, whichever they are; a wave whose
// bins are in time, and a pattern that does not move, raise no alarm.
#include "cases/measure/gas/gas_bin_lag.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

#include <numbers>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr int length = 160, bins = 16;

scene::GasSampling sampling() {
    return {.length = length, .width = 11, .bin = 10, .replicas = 32, .steps = 6000, .every = 10};
}

// 100 particles with noise of 5 and a wave of 20 at .36 sites per step, each bin as it was `late`
// frames before.
measure::Results wave_with(const std::function<double(std::size_t)>& late, std::uint64_t seed = 0,
                           double velocity = 0.36) {
    measure::GasBinLag estimator(sampling());
    return run_gas(sampling(), estimator, [&](SyntheticGas& gas) {
        gas.fill([&](std::size_t i, std::size_t r) {
            const double t = static_cast<double>(gas.step) - 10 * late(i);
            const double x = 10.0 * static_cast<double>(i) - velocity * t;
            const double wave =
                std::cos(2 * std::numbers::pi * x / length + static_cast<double>(r));
            return 100 + 20 * wave +
                   5 * white(seed + static_cast<std::uint64_t>(gas.step), i * 64 + r);
        });
    });
}

double in_time(std::size_t /*bin*/) {
    return 0;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bins_in_time_have_no_lag) {
    int outside = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto v = get(wave_with(in_time, 1'000'000 * seed), "bin_lag_variance");
        BOOST_TEST(v.standard_error < 0.05);
        outside += std::abs(v.value) > 2.04 * v.standard_error ? 1 : 0;
    }
    BOOST_TEST(outside <= 4);  // 5 % each: more in 3 of 1000
}

BOOST_AUTO_TEST_CASE(late_bins_are_found_by_how_much_they_are_late) {
    // Every second bin: all pairs are off by one frame. One bin: two pairs of 16.
    const auto second = wave_with([](std::size_t i) { return static_cast<double>(i % 2); });
    const auto v = get(second, "bin_lag_variance");
    BOOST_TEST(v.value == 1.0, tt::tolerance(0.1));
    BOOST_TEST(v.value > 10 * v.standard_error);
    const auto one =
        get(wave_with([](std::size_t i) { return i == 7 ? 1.0 : 0.0; }), "bin_lag_variance");
    BOOST_TEST(std::abs(one.value - 2.0 / bins) < 4 * one.standard_error);
    // The half of the pipe, three frames late: two pairs again.
    const auto half =
        get(wave_with([](std::size_t i) { return i < bins / 2 ? 3.0 : 0.0; }), "bin_lag_variance");
    BOOST_TEST(half.value > 5 * half.standard_error);
}

BOOST_AUTO_TEST_CASE(what_does_not_move_tells_nothing) {
    BOOST_TEST(!find(wave_with(in_time, 0, 0.0), "bin_lag_variance"));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_measured_is_refused) {
    auto open = sampling();
    open.periodic = false;
    BOOST_CHECK_THROW(measure::GasBinLag{open}, std::invalid_argument);
    auto few = sampling();
    few.replicas = 2;
    BOOST_CHECK_THROW(measure::GasBinLag{few}, std::invalid_argument);
    auto coarse = sampling();
    coarse.bin = 160;
    BOOST_CHECK_THROW(measure::GasBinLag{coarse}, std::invalid_argument);
}
