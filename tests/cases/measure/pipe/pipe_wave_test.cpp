// Wave velocity of grains in a pipe in three ways: waves of known velocity among grains of known
// mean velocity, a pattern carried along, grains without a wave, and frames too far apart.
#include "cases/measure/pipe/pipe_wave.hpp"
#include "tests/cases/measure/synthetic_pipe.hpp"

#include <boost/test/unit_test.hpp>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

measure::Results wave(PipeWaveSpec spec, const scene::Scene& scene = pipe_scene(420)) {
    measure::PipeWave estimator(scene, {});
    return SyntheticPipe(scene, std::move(spec)).run(estimator);
}

}  // namespace

BOOST_AUTO_TEST_CASE(three_velocities_of_a_known_wave) {
    for (const double velocity : {11.3, 5.0, -4.0}) {
        const auto results =
            wave({.velocity = velocity, .shape = cosine_wave(0.6), .diffusion = 1.5});
        const auto overlap = get(results, "overlap_velocity");
        BOOST_TEST_MESSAGE("v " << velocity << ": overlap " << overlap.value << " +- "
                                << overlap.standard_error << ", peak "
                                << get(results, "wave_velocity").value << ", flux slope "
                                << get(results, "flux_slope").value << ", V_w/V "
                                << get(results, "wave_over_speed").value << ", V_w/(dJ/drho) "
                                << get(results, "wave_over_flux_slope").value);
        // Single grains, which fall at 8.24, pull on it: by 0.3 to 4 % of their difference.
        BOOST_TEST(std::abs(overlap.value - velocity) < 4 * overlap.standard_error);
        BOOST_TEST(std::abs(overlap.value - velocity) < 0.02 * std::abs(velocity - 8.24) + 0.05);
        const auto peak = get(results, "wave_velocity");
        BOOST_TEST(std::abs(peak.value - velocity) < peak.systematic);
        BOOST_TEST(peak.settings.at("k") == 1.0);
        BOOST_TEST(get(results, "flux_slope").value == velocity, tt::tolerance(0.03));
        const auto ratio = get(results, "wave_over_speed");
        BOOST_TEST(std::abs(ratio.value - velocity / 8.24) < 4 * ratio.standard_error);
        const auto kinematic = get(results, "wave_over_flux_slope");
        BOOST_TEST(std::abs(kinematic.value - 1) < 4 * kinematic.standard_error);
        BOOST_TEST(get(results, "overlap_wave_fraction").value == 1.0);
        BOOST_TEST(label(results, "wave") == "wave");
    }
}

// A cluster's S(k) may grow by decades in a run. Its error is then as large as S(k) itself, and yet
// nobody doubts the cluster; a pattern in one part of the run only is another matter.
BOOST_AUTO_TEST_CASE(a_growing_cluster_is_a_pattern_and_a_passing_one_is_none) {
    const PipeWaveSpec steady{.shape = cosine_wave(0.9), .diffusion = 0.5};
    PipeWaveSpec growing = steady, passing = steady;
    growing.following = [](double t) { return 0.06 * std::exp2(t / 125); };
    passing.following = [](double t) { return t > 440 ? 1.0 : 0.0; };
    BOOST_TEST(find(wave(growing), "flux_slope") != nullptr);
    BOOST_TEST(find(wave(passing), "flux_slope") == nullptr);
}

BOOST_AUTO_TEST_CASE(the_second_harmonic_of_a_long_pipe) {
    const auto results = wave({.velocity = 12, .shape = cosine_wave(0.6, 2), .diffusion = 1.5},
                              pipe_scene(840, 440));
    BOOST_TEST(get(results, "overlap_velocity").value == 12.0, tt::tolerance(0.02));
    BOOST_TEST(get(results, "wave_velocity").settings.at("k") == 2.0);
    BOOST_TEST(get(results, "wave_velocity").value == 12.0, tt::tolerance(0.03));
}

BOOST_AUTO_TEST_CASE(a_pattern_at_rest_among_the_grains_is_carried) {
    const auto results = wave({.velocity = 8.24, .shape = cosine_wave(0.6), .diffusion = 0.1});
    const auto ratio = get(results, "wave_over_speed");
    BOOST_TEST_MESSAGE("carried: V_w/V " << ratio.value << " +- " << ratio.standard_error);
    BOOST_TEST(ratio.value == 1.0, tt::tolerance(0.005));
    BOOST_TEST(label(results, "wave") == "carried");
}

BOOST_AUTO_TEST_CASE(a_run_too_short_to_tell_does_not_call_its_pattern_carried) {
    // Few grains, thrown about: 6 % of error cannot tell a wave 5 % faster than the grains.
    const auto results = wave({.velocity = 8.65, .shape = cosine_wave(0.5), .diffusion = 6},
                              pipe_scene(150, 220, 120));
    const auto ratio = get(results, "wave_over_speed");
    BOOST_TEST_MESSAGE("short: V_w/V " << ratio.value << " +- " << ratio.standard_error);
    BOOST_TEST(label(results, "wave") == "undecided");
}

BOOST_AUTO_TEST_CASE(grains_without_correlation_have_no_wave) {
    const auto scene = pipe_scene(420);
    for (const std::uint64_t seed : {1, 2, 3}) {
        measure::PipeWave estimator(scene, {});
        const auto results = RandomPipe(scene, 8.24, seed).run(estimator);
        BOOST_TEST(label(results, "wave") == "none");
        BOOST_TEST(!find(results, "overlap_velocity"));
        BOOST_TEST(!find(results, "wave_over_speed"));
        BOOST_TEST(!find(results, "wave_velocity"));
        BOOST_TEST(!find(results, "flux_slope"));
        BOOST_TEST(get(results, "overlap_wave_fraction").value == 0.0);
    }
}

BOOST_AUTO_TEST_CASE(flux_against_density_is_the_straight_line_of_the_wave) {
    const auto results = wave({.shape = cosine_wave(0.6), .diffusion = 1.5});
    const auto phi = column(results, "flux", "phi"), flux = column(results, "flux", "J");
    const double mean = 420 * std::numbers::pi / 4 / 2200;
    for (std::size_t i = 0; i < phi.size(); ++i) {
        if (column(results, "flux", "share")[i] < 0.03) continue;
        // Single grains pull it a little towards the mean velocity.
        const double line = 8.24 * mean + 11.3 * (phi[i] - mean);
        BOOST_TEST(std::abs(flux[i] - line) < 0.05 * 11.3 * mean);
    }
}

BOOST_AUTO_TEST_CASE(frames_too_far_apart_are_refused) {
    auto scene = pipe_scene(420);
    scene.frame_every = 80;  // 0.8: grains fall 6.6, a bin is 5
    const auto results = wave({.shape = cosine_wave(0.6)}, scene);
    BOOST_TEST(label(results, "sampling") == "too coarse");
    BOOST_TEST(!find(results, "wave_velocity"));
}

BOOST_AUTO_TEST_CASE(options_that_make_no_sense_are_refused) {
    const auto scene = pipe_scene(420);
    const auto make = [&](measure::PipeWaveOptions o) { measure::PipeWave estimator(scene, o); };
    BOOST_CHECK_THROW(make({.record = {.bin = 20}}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.record = {.bin = 0}}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.overlap = {.lag_min = 80, .lag_max = 10}}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.overlap = {.smoothing = 120}}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.wavelength_min = 10}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.wavelength_min = 230}), std::invalid_argument);
}
