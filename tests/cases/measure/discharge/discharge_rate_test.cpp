// Flow rate out of a hopper: known rates, constant, falling with the filling as a fluid's, jammed;
// and scenes that are no hopper.
#include "cases/measure/discharge/discharge_rate.hpp"
#include "tests/cases/measure/synthetic_hopper.hpp"
#include "tests/cases/measure/synthetic_pipe.hpp"

#include <boost/test/unit_test.hpp>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

/// Grain i leaves at the time at which `out` (grains) reaches i.
measure::Results discharge(const scene::Scene& scene, const std::function<double(double)>& out,
                           measure::DischargeRateOptions options = {}) {
    measure::DischargeRate estimator(scene, options);
    return run_hopper(scene, estimator, [&](std::size_t i, double t) {
        const bool gone = static_cast<double>(i) < out(t);
        return GrainState{scene.initial.x[i], gone ? -10.0 : scene.initial.y[i], 0, 0};
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(walls_are_found_from_the_frozen_grains) {
    for (const double theta : {10.0, 60.0, 90.0}) {
        const auto walls = measure::hopper_walls(hopper_scene(theta, 12));
        BOOST_TEST(walls.axis == 7.0, tt::tolerance(1e-9));
        BOOST_TEST(walls.level == 5.0, tt::tolerance(1e-9));
        BOOST_TEST(walls.outlet == 12.0, tt::tolerance(1e-9));
        BOOST_TEST(std::atan(walls.tangent) * 360 / std::numbers::pi == theta, tt::tolerance(1e-6));
        BOOST_TEST(std::abs(walls.height - 100) < 1);
        BOOST_TEST(walls.from_wall(7 + walls.half_width, 5) == 0.0, tt::tolerance(1e-9));
        BOOST_TEST(walls.height_of(walls.area_below(33)) == 33.0, tt::tolerance(1e-9));
    }
}

BOOST_AUTO_TEST_CASE(what_is_no_hopper_is_refused) {
    BOOST_CHECK_THROW((void)measure::hopper_walls(plain_scene(3)), std::invalid_argument);
    auto bent = hopper_scene(60);
    for (std::size_t i = 0; i < bent.initial.x.size(); ++i) {
        if (bent.initial.frozen[i] && bent.initial.y[i] > 60) {
            bent.initial.x[i] += bent.initial.x[i] > 7 ? 5 : -5;
        }
    }
    BOOST_CHECK_THROW((void)measure::hopper_walls(bent), std::invalid_argument);
    const auto scene = hopper_scene(60);
    BOOST_CHECK_THROW(measure::DischargeRate(scene, {.from = 8, .to = 8}), std::invalid_argument);
    BOOST_CHECK_THROW(measure::DischargeRate(scene, {.down_to = 1}), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_constant_rate_after_the_transient) {
    const auto scene = hopper_scene(60);
    // Twice as fast for the first five time units.
    const auto results = discharge(scene, [](double t) { return 113.8 * (t + std::min(t, 5.0)); });
    const auto rate = get(results, "flow_rate");
    BOOST_TEST_MESSAGE("113.8: " << rate.value << " +- " << rate.standard_error << ", drift "
                                 << get(results, "flow_rate_drift").value << ", halves "
                                 << get(results, "flow_rate_halves").value << ", exponent "
                                 << get(results, "flow_exponent").value);
    BOOST_TEST(rate.value == 113.8, tt::tolerance(0.002));
    BOOST_TEST(rate.settings.at("outlet") == 20.0, tt::tolerance(1e-9));
    BOOST_TEST(rate.settings.at("half_angle") == 30.0, tt::tolerance(1e-6));
    BOOST_TEST(std::abs(get(results, "flow_rate_drift").value) < 0.005);
    BOOST_TEST(std::abs(get(results, "flow_rate_halves").value) < 0.005);
    BOOST_TEST(std::abs(get(results, "flow_exponent").value) < 0.02);
    BOOST_TEST(label(results, "flow") == "steady");
}

BOOST_AUTO_TEST_CASE(masses_count_not_grains) {
    auto scene = hopper_scene(30);
    scene.grains.masses.assign(scene.grain_count(), 2.5);
    scene.grains.diameters.assign(scene.grain_count(), 1.0);
    const auto results = discharge(scene, [](double t) { return 40 * t; });
    BOOST_TEST(get(results, "flow_rate").value == 100.0, tt::tolerance(0.002));
}

BOOST_AUTO_TEST_CASE(a_fluid_is_told_from_grains) {
    // dm/dt = -c sqrt(h): the rate follows the square root of the height it is told by.
    const auto scene = hopper_scene(60);
    const auto walls = measure::hopper_walls(scene);
    const auto total = static_cast<double>(walls.mobile.size());
    const double area = walls.area_below(98);
    std::vector<double> out{0};
    for (int step = 0; step < 3000; ++step) {
        const double h = walls.height_of(area * (1 - out.back() / total));
        out.push_back(out.back() + 0.01 * 20 * std::sqrt(h));
    }
    const auto results = discharge(
        scene, [&](double t) { return out[static_cast<std::size_t>(std::lround(100 * t))]; });
    const auto exponent = get(results, "flow_exponent");
    BOOST_TEST_MESSAGE("fluid 0.5: " << exponent.value << " +- " << exponent.standard_error);
    BOOST_TEST(exponent.value == 0.5, tt::tolerance(0.03));
    BOOST_TEST(label(results, "flow") == "changing");
    BOOST_TEST(get(results, "flow_rate_drift").value < -0.05);
}

BOOST_AUTO_TEST_CASE(a_jammed_hopper_and_a_closed_one) {
    const auto scene = hopper_scene(60);
    const auto jams = discharge(scene, [](double t) { return 100 * std::min(t, 14.0); });
    BOOST_TEST(label(jams, "flow") == "jammed");
    const auto closed = discharge(scene, [](double) { return 0.0; });
    BOOST_TEST(closed.measurements.empty());
}

BOOST_AUTO_TEST_CASE(the_window_ends_when_the_hopper_is_nearly_empty) {
    const auto scene = hopper_scene(20);
    const auto total = static_cast<double>(measure::hopper_walls(scene).mobile.size());
    const auto results = discharge(scene, [&](double t) { return total * t / 25; });
    BOOST_TEST(get(results, "flow_rate").settings.at("to") == 17.5, tt::tolerance(0.01));
    BOOST_TEST(get(results, "flow_rate").value == total / 25, tt::tolerance(0.01));
    const auto early = discharge(scene, [&](double t) { return total * t / 5; });
    BOOST_TEST(!find(early, "flow_rate"));  // empty before the window begins
}
