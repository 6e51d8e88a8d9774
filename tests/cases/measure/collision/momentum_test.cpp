// Drift of known size, and scenes whose momentum is not conserved.
#include "cases/measure/collision/momentum.hpp"

#include "tests/cases/measure/synthetic_frame.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

// Two grains flying apart with speed 3 and 4; the last frame but one is pushed by (dx, dy).
measure::Results run(const scene::Scene& scene, double dx, double dy, int frames = 5) {
    measure::Momentum estimator(scene);
    for (int i = 0; i < frames; ++i) {
        SyntheticFrame frame{.step = i, .time = 0.1 * i};
        const bool pushed = i == frames - 2;
        frame.add_grain(0, 0, 3 + (pushed ? dx : 0), 0);
        frame.add_grain(9, 0, 0, -4 + (pushed ? dy : 0));
        estimator.add(frame.view());
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(worst_drift_relative_to_the_random_momentum) {
    auto scene = plain_scene(2);
    scene.grains.mass = 2;
    const auto results = run(scene, 1e-6, -2e-6);
    // Scale m sqrt(9 + 16), up to the push itself.
    BOOST_TEST(get(results, "momentum_drift_x").value == 1e-6 / 5, tt::tolerance(1e-5));
    BOOST_TEST(get(results, "momentum_drift_y").value == 2e-6 / 5, tt::tolerance(1e-5));
    BOOST_TEST(get(results, "momentum_drift_x").n == 5U);
}

BOOST_AUTO_TEST_CASE(no_drift_is_zero) {
    const auto results = run(plain_scene(2), 0, 0);
    BOOST_TEST(get(results, "momentum_drift_x").value == 0);
    BOOST_TEST(get(results, "momentum_drift_y").value == 0);
}

BOOST_AUTO_TEST_CASE(gravity_and_plates_leave_x_only) {
    auto falling = plain_scene(2);
    falling.gravity = 1;
    auto with_bottom = plain_scene(2);
    with_bottom.plates.bottom = scene::PrescribedPlate{};
    auto with_lid = plain_scene(2);
    with_lid.plates.lid = scene::FreeLid{.mass = 1};
    for (const auto& scene : {falling, with_bottom, with_lid}) {
        const auto results = run(scene, 0, 0);
        BOOST_TEST(find(results, "momentum_drift_x"));
        BOOST_TEST(!find(results, "momentum_drift_y"));
    }
}

BOOST_AUTO_TEST_CASE(nothing_where_nothing_is_conserved_or_known) {
    auto frozen = plain_scene(2);
    frozen.initial.frozen = {true, false};
    BOOST_TEST(run(frozen, 0, 0).measurements.empty());
    BOOST_TEST(run(plain_scene(2), 0, 0, 1).measurements.empty());
    measure::Momentum at_rest(plain_scene(1));
    SyntheticFrame frame;
    frame.add_grain(0, 0, 0, 0);
    at_rest.add(frame.view());
    at_rest.add(frame.view());
    measure::Results results;
    at_rest.finish(results);
    BOOST_TEST(results.measurements.empty());
}
