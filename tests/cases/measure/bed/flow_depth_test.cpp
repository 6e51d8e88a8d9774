// Beds in which a known number of rows is exchanged every period.
#include "cases/measure/bed/flow_depth.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr int columns = 16, rows = 10;
constexpr double row_height = std::numbers::sqrt3, period = 6;

scene::Scene bed() {
    auto scene = plain_scene(columns * rows);
    scene.periodic_x = 2.0 * columns;
    scene.dt = 0.5;
    scene.frame_every = 1;
    scene.plates.bottom = scene::PrescribedPlate{.amplitude = 2, .period = period};
    return scene;
}

/// A triangular lattice; the rows from `solid` on move past each other by a grain per period, in
/// alternating directions. All of it rises and widens by `swell` in every second period.
measure::Results run(int solid, int periods, double swell = 0, const scene::Scene& scene = bed()) {
    measure::FlowDepth estimator(scene, {.skip = period});
    for (int f = 0; f <= 12 * (periods + 1); ++f) {
        SyntheticFrame frame{.step = f, .time = 0.5 * f};
        const double n = frame.time / period;
        const double stretch = 1 + swell * (static_cast<int>(n) % 2);
        for (int i = 0; i < columns * rows; ++i) {
            const int row = i / columns;
            const double slid = row >= solid ? 2.0 * n * (row % 2 == 0 ? 1 : -1) : 0.0;
            frame.add_grain(2.0 * (i % columns) + row % 2 + slid, stretch * row_height * row + n, 0,
                            0);
        }
        estimator.add(frame.view());
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_solid_does_not_flow_whatever_it_does_as_a_whole) {
    for (const double swell : {0.0, 0.1}) {
        const auto results = run(rows, 20, swell);
        BOOST_TEST(get(results, "flow_depth").value == 0);
        BOOST_TEST(get(results, "flow_depth").standard_error == 0);
        BOOST_TEST(get(results, "lost_bonds").value == 0);
    }
}

BOOST_AUTO_TEST_CASE(rows_that_move_past_each_other_flow) {
    // Rows 6 to 9 move; row 5 does not, but loses its bonds to row 6.
    const auto results = run(6, 20);
    BOOST_TEST(get(results, "flowing_layers").value == 5);
    BOOST_TEST(get(results, "flow_depth").value == 5 * row_height, tt::tolerance(1e-12));
    BOOST_TEST(get(results, "flow_depth").n == 20U);
    const auto profile = column(results, "flow-profile", "lost_bonds");
    BOOST_TEST_REQUIRE(profile.size() == static_cast<std::size_t>(rows));
    BOOST_TEST(profile[0] == 0);
    BOOST_TEST(profile[4] == 0);
    BOOST_TEST(profile[7] > 0.2);
}

BOOST_AUTO_TEST_CASE(a_fluid_flows_all_through) {
    BOOST_TEST(get(run(0, 20), "flowing_layers").value == rows);
}

BOOST_AUTO_TEST_CASE(too_few_periods_say_nothing) {
    BOOST_TEST(run(0, 8).measurements.empty());
}

BOOST_AUTO_TEST_CASE(a_bottom_at_rest_says_nothing) {
    auto still = bed();
    still.plates.bottom->amplitude = 0;
    BOOST_TEST(run(0, 20, 0, still).measurements.empty());
}

BOOST_AUTO_TEST_CASE(rejects_a_share_that_makes_no_sense) {
    for (const double share : {0.0, 1.0, -1.0}) {
        BOOST_CHECK_THROW(measure::FlowDepth(bed(), {.share = share}), std::invalid_argument);
    }
}
