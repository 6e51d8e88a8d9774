// Craters of known depth, width and slope.
#include "cases/measure/hopper/hopper_surface.hpp"

#include "tests/cases/measure/hopper_frames.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

/// Height of the surface at x in a replica.
using Profile = std::function<double(double, int)>;

measure::Results run(const Profile& height) {
    const auto scene = hopper_scene(20, 400, 36.87, 4, 10, 10);
    measure::HopperSurface estimator(scene);
    for (int r = 0; r < scene.replicas; ++r) {
        const HopperFilling filling(scene, [&](auto c, auto k) {
            const double x = static_cast<double>(c) * std::numbers::sqrt3 / 2;
            return static_cast<double>(k) / 2 <= height(x, r) ? std::uint8_t{1} : std::uint8_t{0};
        });
        estimator.add(filling.view(scene, r, 10));
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_wedge_has_its_depth_width_and_slope) {
    // The top lies at 199.5; walls of 45 degrees down to 159.5.
    const auto results = run([](double x, int) { return 159.5 + std::abs(x); });
    // Columns are half a level apart in height at most.
    BOOST_TEST(std::abs(get(results, "crater_depth").value - 40) <= 0.5);
    BOOST_TEST(std::abs(get(results, "crater_half_width").value - 38) <= 1.5);
    BOOST_TEST(std::abs(get(results, "surface_slope").value - 45) < 0.5);
    BOOST_TEST(std::abs(get(results, "surface_slope_steepest").value - 45) < 6);
    BOOST_TEST(get(results, "surface_scatter").value == 0.0);
    BOOST_TEST(get(results, "steep_share").value == 1.0);
}

BOOST_AUTO_TEST_CASE(a_gentle_wedge_is_not_steep) {
    const auto results = run([](double x, int) { return 175 + 0.5 * std::abs(x); });
    BOOST_TEST(std::abs(get(results, "surface_slope").value - 26.57) < 0.5);
    BOOST_TEST(get(results, "steep_share").value == 0.0);
}

BOOST_AUTO_TEST_CASE(a_steep_place_is_found_in_a_gentle_crater) {
    const double gentle = std::tan(std::numbers::pi / 9);  // 20 degrees
    const auto results = run([&](double x, int) {
        const double step = std::abs(x) > 30 ? 20.0 : 0.0;
        return 150 + gentle * std::abs(x) + step;
    });
    BOOST_TEST(get(results, "surface_slope").value < 40);
    BOOST_TEST(get(results, "surface_slope_steepest").value > 60);
}

BOOST_AUTO_TEST_CASE(the_scatter_between_replicas_is_relative_to_the_depth) {
    // Flat craters of depths 40, 44, 40, 44: standard deviation sqrt(8) in 42.
    const auto results = run([](double x, int replica) {
        if (std::abs(x) > 50) return 199.5;
        return replica % 2 == 0 ? 159.5 : 155.5;
    });
    BOOST_TEST(get(results, "surface_scatter").value == std::sqrt(8.0) / 42, tt::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(a_full_hopper_has_no_crater) {
    const auto results = run([](double, int) { return 1000.0; });
    BOOST_TEST(!find(results, "crater_depth"));
    BOOST_TEST(!find(results, "surface_slope"));
    const auto& h = column(results, "surface", "h");
    BOOST_TEST(h[h.size() / 2] >= 199.0);
}

BOOST_AUTO_TEST_CASE(several_angles_are_refused) {
    auto scene = hopper_scene(20, 400, 36.87, 4, 10, 10);
    scene.angles = {20, 30};
    BOOST_CHECK_THROW(measure::HopperSurface{scene}, std::invalid_argument);
}
