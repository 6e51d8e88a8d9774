// Wave velocity by overlap: known waves in noise, noise alone, and a pattern at rest.
#include "cases/measure/gas/gas_overlap.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

#include <numbers>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

scene::GasSampling sampling(int replicas, int length = 512) {
    return {
        .length = length, .width = 11, .bin = 4, .replicas = replicas, .steps = 5000, .every = 10};
}

// Bins of 44 particles with white noise of 6, and a wave of the given amplitude and velocity.
measure::Results travelling(double amplitude, double velocity, int replicas, std::uint64_t seed = 0,
                            int length = 512) {
    const auto gas_sampling = sampling(replicas, length);
    measure::GasOverlap overlap(gas_sampling, {});
    return run_gas(gas_sampling, overlap, [&](SyntheticGas& gas) {
        const auto t = static_cast<double>(gas.step);
        gas.fill([&](std::size_t i, std::size_t r) {
            const double x = 4.0 * static_cast<double>(i) - velocity * t;
            const double wave =
                std::cos(2 * std::numbers::pi * x / length + static_cast<double>(r));
            return 44 + amplitude * wave +
                   6 * white(seed + static_cast<std::uint64_t>(gas.step), i * 64 + r);
        });
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(velocities_of_waves_in_noise_within_one_per_cent) {
    for (const double velocity : {0.36, 0.5, -0.25}) {
        const auto results = travelling(12, velocity, 16);
        BOOST_TEST(get(results, "overlap_wave_fraction").value == 1.0);
        const auto measured = get(results, "overlap_velocity");
        BOOST_TEST(measured.value == velocity, tt::tolerance(0.01));
        BOOST_TEST(std::abs(measured.value - velocity) < 4 * measured.standard_error);
        BOOST_TEST(measured.n == 16U);
        BOOST_TEST(column(results, "overlap", "shift").back() == 320 * velocity,
                   tt::tolerance(0.02));
    }
}

BOOST_AUTO_TEST_CASE(white_noise_has_no_wave) {
    std::size_t waves = 0;
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
        for (const int length : {512, 220}) {
            const auto results = travelling(0, 0, 50, (seed + 1) * 1'000'000, length);
            const auto share = get(results, "overlap_wave_fraction");
            waves += static_cast<std::size_t>(std::lround(share.value * 50));
            // Too few for a velocity.
            BOOST_TEST(!find(results, "overlap_velocity"));
        }
    }
    BOOST_TEST(waves == 0U);  // of 200
}

BOOST_AUTO_TEST_CASE(a_pattern_at_rest_is_no_wave) {
    const auto results = travelling(10, 0, 8);
    BOOST_TEST(get(results, "overlap_wave_fraction").value == 0.0);
    BOOST_TEST(std::abs(column(results, "overlap", "shift").back()) < 4);
    BOOST_TEST(column(results, "overlap", "height").back() > 0.8);
}

BOOST_AUTO_TEST_CASE(free_fall_is_no_wave) {
    const auto results = travelling(12, 1.0, 8);
    BOOST_TEST(get(results, "overlap_wave_fraction").value == 0.0);
    BOOST_TEST(get(results, "overlap_other_fraction").value == 1.0);
    BOOST_TEST(!find(results, "overlap_velocity"));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_measured_is_refused) {
    auto open = sampling(4);
    open.periodic = false;
    BOOST_CHECK_THROW((measure::GasOverlap{open, {}}), std::invalid_argument);
    auto coarse = sampling(4);
    coarse.every = 320;
    coarse.steps = 6400;
    BOOST_CHECK_THROW((measure::GasOverlap{coarse, {}}), std::invalid_argument);
    BOOST_CHECK_THROW((measure::GasOverlap{sampling(4), {.smoothing = 256}}),
                      std::invalid_argument);
    BOOST_CHECK_THROW((measure::GasOverlap{sampling(4), {.v_min = .6, .v_max = .6}}),
                      std::invalid_argument);
    auto brief = sampling(4);
    brief.steps = 300;
    BOOST_CHECK_THROW((measure::GasOverlap{brief, {}}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_run_that_ended_early_has_no_velocity) {
    measure::GasOverlap overlap(sampling(4), {});
    SyntheticGas gas(sampling(4));
    for (int f = 0; f < 20; ++f)
        overlap.add(gas.view());
    measure::Results results;
    overlap.finish(results);
    BOOST_TEST(results.measurements.empty());
    BOOST_TEST(results.series.empty());
}
