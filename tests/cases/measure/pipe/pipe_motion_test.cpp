// Mean velocity, temperature and steady state of grains in a pipe: a gas of known motion, a gas
// that goes on accelerating, and scenes that are no pipe.
#include "cases/measure/pipe/pipe_motion.hpp"
#include "tests/cases/measure/synthetic_pipe.hpp"

#include <boost/test/unit_test.hpp>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

measure::Results motion(const scene::Scene& scene, PipeWaveSpec spec) {
    measure::PipeMotion estimator(scene, {});
    return SyntheticPipe(scene, std::move(spec)).run(estimator);
}

}  // namespace

BOOST_AUTO_TEST_CASE(section_of_a_pipe_between_frozen_columns) {
    auto scene = pipe_scene(420);
    const auto section = measure::pipe_section(scene);
    BOOST_TEST(section.clear_width == 10.0, tt::tolerance(1e-12));
    BOOST_TEST(section.mobile.size() == 420U);
    BOOST_TEST(section.area_fraction == 420 * std::numbers::pi / 4 / 2200, tt::tolerance(1e-12));
    BOOST_TEST(section.interval == 0.2, tt::tolerance(1e-12));
    BOOST_TEST(section.down(-3) == 3.0);
    BOOST_TEST(section.down(3) == 217.0);
    BOOST_TEST(section.down(-443) == 3.0);
    BOOST_TEST(section.down(1e-15) < 220.0);
    scene.grains.diameters.assign(scene.grain_count(), 1.0);
    scene.grains.diameters[0] = 2;  // one mobile grain is larger
    BOOST_TEST(measure::pipe_section(scene).area_fraction == 423 * std::numbers::pi / 4 / 2200,
               tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(smooth_walls_are_the_backing_planes) {
    auto scene = plain_scene(10);
    scene.grains.diameter = 1;
    scene.periodic_y = 220;
    BOOST_CHECK_THROW((void)measure::pipe_section(scene), std::invalid_argument);
    scene.backing = {.stiffness = 1, .left = 0.5, .right = 9.5};
    BOOST_TEST(measure::pipe_section(scene).clear_width == 10.0);
    scene.periodic_y.reset();
    BOOST_CHECK_THROW((void)measure::pipe_section(scene), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(mean_velocity_temperature_and_spins_of_a_known_gas) {
    const auto scene = pipe_scene(420);
    const auto results =
        motion(scene, {.shape = cosine_wave(0.6), .thermal = 2, .diffusion = 0.3, .seed = 5});
    const auto speed = get(results, "mean_speed");
    BOOST_TEST(speed.value == 8.24, tt::tolerance(0.005));
    BOOST_TEST(std::abs(speed.value - 8.24) < 4 * speed.standard_error);
    BOOST_TEST(get(results, "flux").value == speed.value * 420 * std::numbers::pi / 4 / 2200,
               tt::tolerance(1e-12));
    // Velocities change along the wave by -2.2 to 4.6: that is no temperature.
    const auto temperature = get(results, "granular_temperature");
    BOOST_TEST(temperature.value == 4.0, tt::tolerance(0.02));
    BOOST_TEST(get(results, "mean_square_spin").value == 5.0, tt::tolerance(1e-12));
    BOOST_TEST(label(results, "state") == "steady");
}

BOOST_AUTO_TEST_CASE(free_fall_is_no_steady_state) {
    const auto scene = pipe_scene(50, 220, 100);
    measure::PipeMotion estimator(scene, {});
    std::vector<double> vy(scene.grain_count());
    for (std::int64_t step = 0; step <= scene.steps; step += scene.frame_every) {
        const double t = static_cast<double>(step) * scene.dt;
        for (std::size_t i = 0; i < vy.size(); ++i)
            vy[i] = -t + 0.1 * static_cast<double>(i % 7);
        const auto& state = scene.initial;
        estimator.add({.step = step,
                       .time = t,
                       .x = state.x,
                       .y = state.y,
                       .vx = state.vx,
                       .vy = vy,
                       .lid = {},
                       .omega = {}});
    }
    measure::Results results;
    estimator.finish(results);
    BOOST_TEST(label(results, "state") == "ageing");
    BOOST_TEST(get(results, "drift_speed").value > 1.0);
    BOOST_TEST(!find(results, "mean_speed"));  // of something that has no mean
    BOOST_TEST(!find(results, "mean_square_spin"));
}

BOOST_AUTO_TEST_CASE(frames_before_the_skip_do_not_count_and_few_frames_say_nothing) {
    const auto scene = pipe_scene(50, 220, 100);
    measure::PipeMotion estimator(scene, {.record = {.skip = 90}});
    const auto results = SyntheticPipe(scene, {}).run(estimator);
    BOOST_TEST(results.measurements.empty());
    BOOST_TEST(results.findings.empty());
}
