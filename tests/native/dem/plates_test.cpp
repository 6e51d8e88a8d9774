// Plates: elastic, at the grain's centre or its surface, prescribed or a lid that moves freely.
#include "native/dem/plates.hpp"
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

dem::Parameters with_plates(double dt) {
    auto p = free_discs(law_variants[0], dt);
    p.plate_stiffness = p.stiffness;
    return p;
}

dem::State grain_at(double y, double vy) {
    dem::State state;
    add_disc(state, 0, y, 0, vy);
    return state;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_plate_at_rest_reflects_with_restitution_one_after_half_a_cycle) {
    auto p = with_plates(1e-5);
    p.bottom = dem::MovingPlate{.height = 0};
    dem::Engine engine(p, grain_at(0, -1));
    std::int64_t steps = 0;
    while (engine.state().step == 0 || engine.state().y[0] < 0)
        engine.advance(1), ++steps;
    // omega dt = 2e-4: the step that ends the contact is late by at most one.
    BOOST_TEST(engine.state().vy[0] == 1.0, tt::tolerance(1e-6));
    const double contact_time = std::numbers::pi / std::sqrt(p.plate_stiffness);
    BOOST_TEST(std::abs(static_cast<double>(steps) * p.dt - contact_time) < 2 * p.dt);
    BOOST_TEST(engine.state().vx[0] == 0.0);
}

BOOST_AUTO_TEST_CASE(plates_do_not_touch_the_motion_along_them) {
    auto p = with_plates(1e-3);
    p.bottom = dem::MovingPlate{.height = 0, .amplitude = 0.1, .omega = 10};
    auto state = grain_at(0.5, -1);
    state.vx[0] = 0.3;
    BOOST_TEST(after(p, state, 2000).vx[0] == 0.3);
}

BOOST_AUTO_TEST_CASE(a_prescribed_plate_follows_the_cosine_whatever_pushes_it) {
    const dem::MovingPlate plate{.height = 0.25, .amplitude = 0.5, .omega = 2 * std::numbers::pi};
    BOOST_TEST(plate.position(0) == 0.75);
    // 1e-15: pi is rounded.
    BOOST_TEST(plate.position(0.5) == -0.25, tt::tolerance(1e-15));
    BOOST_TEST(std::abs(plate.position(0.25) - 0.25) < 1e-15);
    BOOST_TEST(plate.position(1.0) == 0.75, tt::tolerance(1e-15));
    // A grain on a stiff plate stays with it: acceleration 0.5 (2 pi)^2/100 is below gravity.
    auto p = with_plates(1e-3);
    p.plate_stiffness = 1e4;
    p.gravity = 1;
    p.bottom = dem::MovingPlate{.height = 0, .amplitude = 0.5, .omega = 0.2 * std::numbers::pi};
    dem::Engine engine(p, grain_at(0.5, 0));
    for (int quarter = 1; quarter <= 4; ++quarter) {
        engine.advance(2500);
        const double at = p.bottom->position(2.5 * quarter);
        // It sinks in by m g/k = 1e-4 and oscillates about that.
        BOOST_TEST(std::abs(engine.state().y[0] - at) < 3e-4);
    }
}

BOOST_AUTO_TEST_CASE(touching_the_surface_differs_from_the_centre_by_exactly_the_radius) {
    for (const auto& law : law_variants) {
        auto centre = free_discs(law, 1e-3);
        centre.period_x = 15;
        centre.gravity = 1;
        centre.plate_stiffness = centre.stiffness;
        centre.bottom = dem::MovingPlate{.height = 0, .amplitude = 0.5, .omega = 3};
        auto surface = centre;
        surface.plate_reach = 1;
        surface.bottom->height = -1;
        centre.lid = dem::InertialLid{.mass = 5};
        surface.lid = centre.lid;
        auto under_centre = hot_gas(6, 2.5), under_surface = under_centre;
        under_centre.lid_height = 15;
        under_surface.lid_height = 16;
        const auto a = after(centre, under_centre, 300);
        auto b = after(surface, under_surface, 300);
        BOOST_TEST(std::abs(a.lid_velocity + 0.3) > 0.1);  // the lid has been hit
        b.lid_height -= 1;
        // Round-off of 1e-15, grown by the collisions of 0.3 time units.
        BOOST_TEST_CONTEXT(law.name) {
            BOOST_TEST(largest_difference(a, b) < 1e-11);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_free_lid_without_contact_falls_like_a_stone) {
    for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
        auto p = with_plates(1e-3);
        p.scheme = scheme;
        p.gravity = 1.5;
        p.lid = dem::InertialLid{.mass = 7};
        auto state = grain_at(-1000, 0);
        state.lid_height = 20;
        state.lid_velocity = 2;
        const auto end = after(p, state, 3000);
        // Verlet is exact for a constant acceleration: 3000 roundings of numbers up to 20.
        BOOST_TEST(end.lid_height == 20 + 2 * 3 - 1.5 * 9 / 2, tt::tolerance(1e-12));
        BOOST_TEST(end.lid_velocity == 2 - 1.5 * 3, tt::tolerance(1e-12));
        BOOST_TEST(end.y[0] == -1000 - 1.5 * 9 / 2, tt::tolerance(1e-13));
    }
}

BOOST_AUTO_TEST_CASE(grains_and_lid_keep_their_momentum_without_gravity) {
    for (const auto& law : law_variants) {
        auto p = free_discs(law, 1e-3);
        p.plate_stiffness = p.stiffness;
        p.lid = dem::InertialLid{.mass = 5};
        auto gas = hot_gas(6, 2.5);
        gas.lid_height = 15;
        for (const double x : {20.0, 25.0, 30.0})
            add_disc(gas, x, 14.5, 0, 3);  // three push the lid at once
        const auto end = after(p, gas, 1000);
        BOOST_TEST(end.lid_velocity > 0.5);  // the gas has thrown it off
        const auto before = momentum(p, gas), now = momentum(p, end);
        BOOST_TEST_CONTEXT(law.name) {
            // 40 momenta of order 3 to 10, each rounded 2000 times.
            BOOST_TEST(std::abs(now[0] - before[0]) < 1e-12);
            BOOST_TEST(std::abs(now[1] - before[1]) < 1e-12);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_grain_and_a_lid_bounce_like_two_elastic_bodies) {
    auto p = with_plates(1e-5);
    p.lid = dem::InertialLid{.mass = 3};
    auto state = grain_at(-0.01, 1);
    const auto end = after(p, state, 20000);
    // v' = (m - M)/(m + M), V' = 2 m/(m + M); omega dt = 3e-4, its square is 1e-7.
    BOOST_TEST(end.vy[0] == -0.5, tt::tolerance(1e-6));
    BOOST_TEST(end.lid_velocity == 0.5, tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(gravity_acts_on_grains_along_minus_y_only) {
    auto p = free_discs(law_variants[0], 1e-3);
    p.gravity = 1;
    const auto end = after(p, grain_at(0, 0), 1000);
    BOOST_TEST(end.y[0] == -0.5, tt::tolerance(1e-12));  // exact but for 1000 roundings
    BOOST_TEST(end.vy[0] == -1.0, tt::tolerance(1e-12));
    BOOST_TEST(end.x[0] == 0.0);
}
