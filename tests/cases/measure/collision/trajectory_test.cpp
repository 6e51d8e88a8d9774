// Snapshots at frame times, and at times that are none.
#include "cases/measure/collision/trajectory.hpp"

#include "tests/cases/measure/synthetic_frame.hpp"

#include <boost/test/unit_test.hpp>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

measure::Results run(double dt, std::int64_t frame_every, std::vector<double> times) {
    auto scene = plain_scene(2);
    scene.dt = dt;
    for (double& time : times)
        time /= scene::contact_time(scene);
    measure::Trajectory estimator(scene, {.at_contact_times = std::move(times)});
    for (std::int64_t step = 0; step <= 10 * frame_every; step += frame_every) {
        SyntheticFrame frame{.step = step, .time = static_cast<double>(step) * dt};
        const auto s = static_cast<double>(step);
        frame.add_grain(s, 2 * s, 0, 0);
        frame.add_grain(-s, 3 * s, 0, 0);
        estimator.add(frame.view());
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(keeps_the_frames_asked_for_in_their_order) {
    // 0.3 is not a multiple of 0.1 in binary.
    const auto results = run(0.1, 1, {0.3, 0.0, 1.0});
    BOOST_TEST_REQUIRE(results.snapshots.size() == 3U);
    BOOST_TEST(results.snapshots[0].time == 0);
    BOOST_TEST(results.snapshots[1].x[1] == -3);
    BOOST_TEST(results.snapshots[1].y[1] == 9);
    BOOST_TEST(results.snapshots[2].x[0] == 10);
}

BOOST_AUTO_TEST_CASE(never_takes_a_neighbouring_frame) {
    BOOST_TEST(run(0.1, 1, {0.35, 0.30001, -0.1, 1.1}).snapshots.empty());
    // Step 3 is no frame.
    BOOST_TEST(run(0.1, 2, {0.3}).snapshots.empty());
    BOOST_TEST(run(0.1, 2, {}).snapshots.empty());
}

BOOST_AUTO_TEST_CASE(a_time_asked_for_twice_is_kept_once) {
    BOOST_TEST(run(0.1, 1, {0.2, 0.2}).snapshots.size() == 1U);
}
