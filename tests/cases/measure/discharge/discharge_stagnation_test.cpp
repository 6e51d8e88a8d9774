// P_eps of a hopper: a known profile of velocities at the walls, mass flow, and grains that do not
// move.
#include "cases/measure/discharge/discharge_stagnation.hpp"
#include "tests/cases/measure/synthetic_hopper.hpp"
#include "tests/cases/measure/synthetic_pipe.hpp"

#include <boost/test/unit_test.hpp>
#include <fmt/format.h>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

/// Grains stay where they are and move at (1 + 2/(1 + h)) (centre) times `ratio`(height over that
/// of the walls) at the walls, along these, with noise.
measure::Results stagnation(double theta, const std::function<double(double)>& ratio,
                            double noise = 0.3) {
    const auto scene = hopper_scene(theta);
    const auto walls = measure::hopper_walls(scene);
    measure::DischargeStagnation estimator(scene, {});
    return run_hopper(scene, estimator, [&](std::size_t i, double t) {
        const double x = scene.initial.x[i], y = scene.initial.y[i];
        const double h = (y - walls.level) / walls.height, centre = 1 + 2 / (1 + h);
        const auto frame = static_cast<std::uint64_t>(std::lround(10 * t));
        const auto n = normal_pair(3, RandomStream::jitter, frame * 20'000 + i);
        GrainState state{x, y, noise * n[0], noise * n[1]};
        if (walls.from_wall(x, y) < 1.5) {
            const double along = std::hypot(1, walls.tangent), v = centre * ratio(h);
            state.vx += (x > walls.axis ? -1 : 1) * v * walls.tangent / along;
            state.vy -= v / along;
        } else {
            state.vy -= centre;
        }
        return state;
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(heights_of_a_known_profile) {
    for (const double theta : {30.0, 90.0}) {
        const auto results = stagnation(theta, [](double h) { return std::max(0.0, 1 - h / 0.6); });
        for (const double eps : {0.1, 0.2, 0.3}) {
            const auto p = get(results, fmt::format("moving_fraction_{:g}", eps));
            BOOST_TEST_MESSAGE("theta " << theta << ", eps " << eps << ": " << p.value << " +- "
                                        << p.standard_error << ", known " << 0.6 * (1 - eps));
            BOOST_TEST(p.value == 0.6 * (1 - eps), tt::tolerance(0.02));
            BOOST_TEST(std::abs(p.value - 0.6 * (1 - eps)) < 4 * p.standard_error + 0.01);
        }
        BOOST_TEST(label(results, "state") == "funnel flow");
    }
}

BOOST_AUTO_TEST_CASE(mass_flow_is_one) {
    const auto results = stagnation(10, [](double h) { return 0.9 - 0.3 * h; });
    for (const char* p : {"moving_fraction_0.1", "moving_fraction_0.2", "moving_fraction_0.3"}) {
        BOOST_TEST(get(results, p).value == 1.0);
        BOOST_TEST(get(results, p).standard_error == 0.0);
    }
    BOOST_TEST(label(results, "state") == "mass flow");
}

BOOST_AUTO_TEST_CASE(an_avalanche_at_the_surface_is_not_the_height) {
    // The upper tenth moves again: the first fall below eps counts.
    const auto results =
        stagnation(60, [](double h) { return h > 0.9 ? 1.0 : std::max(0.0, 1 - h / 0.5); });
    BOOST_TEST(get(results, "moving_fraction_0.2").value == 0.4, tt::tolerance(0.03));
}

BOOST_AUTO_TEST_CASE(grains_that_do_not_flow_say_nothing) {
    const auto scene = hopper_scene(60);
    measure::DischargeStagnation estimator(scene, {});
    const auto results = run_hopper(scene, estimator, [&](std::size_t i, double) {
        return GrainState{scene.initial.x[i], scene.initial.y[i], 0, 0};
    });
    BOOST_TEST(results.measurements.empty());
    BOOST_TEST(results.findings.empty());
    measure::DischargeStagnation later(scene, {.from = 4, .to = 40});
    BOOST_TEST(run_hopper(scene, later, [&](std::size_t i, double) {
                   return GrainState{scene.initial.x[i], scene.initial.y[i], 0, -1};
               }).measurements.empty());
}

BOOST_AUTO_TEST_CASE(options_that_make_no_sense_are_refused) {
    const auto scene = hopper_scene(60);
    const auto make = [&](measure::DischargeStagnationOptions o) {
        measure::DischargeStagnation estimator(scene, o);
    };
    BOOST_CHECK_THROW(make({.from = 20, .to = 4}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.bin = 0}), std::invalid_argument);
    BOOST_CHECK_THROW(make({.shares = {0.1, 1.0}}), std::invalid_argument);
}
