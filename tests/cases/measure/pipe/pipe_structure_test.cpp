// Spatial spectrum of grains in a pipe: grains without correlation, one wave, and a field of waves
// with a known exponent.
#include "cases/measure/pipe/pipe_structure.hpp"
#include "tests/cases/measure/synthetic_pipe.hpp"

#include <boost/test/unit_test.hpp>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

BOOST_AUTO_TEST_CASE(grains_without_correlation_are_flat) {
    const auto scene = pipe_scene(420, 220, 200);
    measure::PipeStructure estimator(scene, {});
    const auto results = RandomPipe(scene, 8, 4).run(estimator);
    const auto exponent = get(results, "wave_number_exponent");
    BOOST_TEST_MESSAGE("random: " << exponent.value << " +- " << exponent.standard_error);
    BOOST_TEST(std::abs(exponent.value) < 0.1);
    BOOST_TEST(std::abs(exponent.value) < 4 * exponent.standard_error);
    for (const double s : column(results, "wave-numbers", "S"))
        BOOST_TEST(s == 1.0, tt::tolerance(0.15));
}

BOOST_AUTO_TEST_CASE(one_wave_has_the_structure_factor_of_its_amplitude) {
    // |n_1| = N a/2, so that S(1) = N a^2/4 + 1.
    const auto scene = pipe_scene(420, 220, 100);
    measure::PipeStructure estimator(scene, {});
    const auto results =
        SyntheticPipe(scene, {.shape = cosine_wave(0.6), .diffusion = 1}).run(estimator);
    BOOST_TEST(column(results, "wave-numbers", "S").front() == 420 * 0.09 + 1, tt::tolerance(0.1));
    BOOST_TEST(get(results, "wave_number").value == 1.0);
}

BOOST_AUTO_TEST_CASE(a_known_exponent_is_found) {
    // Amplitudes a_k = 0.3/k^(0.9): S = N a_k^2/4 ~ k^-1.8, far above 1.
    const auto scene = pipe_scene(60000, 220, 26);
    const auto shape = [](double xi) {
        double f = 1;
        for (int k = 1; k <= 7; ++k)
            f += 0.3 * std::pow(k, -0.9) * std::cos(2 * std::numbers::pi * (k * xi + 0.37 * k * k));
        return f;
    };
    measure::PipeStructure estimator(scene, {});
    const auto results = SyntheticPipe(scene, {.shape = shape}).run(estimator);
    const auto exponent = get(results, "wave_number_exponent");
    BOOST_TEST_MESSAGE("k^-1.8: " << exponent.value << " +- " << exponent.standard_error);
    BOOST_TEST(exponent.value == -1.8, tt::tolerance(0.04));
}

BOOST_AUTO_TEST_CASE(windows_that_make_no_sense_are_refused) {
    const auto scene = pipe_scene(10);
    const auto make = [&](measure::PipeStructureOptions o) {
        measure::PipeStructure estimator(scene, o);
    };
    BOOST_CHECK_THROW(make({.k_min = 0}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.k_min = 7, .k_max = 7}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.k_max = 65}), std::invalid_argument);
}
