// Grains that touch without overlap do not interact, and free flight is exactly straight.
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr double just_below_two = 2 - std::numeric_limits<double>::epsilon();

/// Velocity along y of the left grain after one step, of two grains that slide past each other at
/// a distance; only a dashpot across the normal could change it.
double sliding_speed(const LawVariant& law, double distance) {
    dem::State state;
    add_disc(state, 0, 0, 0, 1);
    add_disc(state, distance, 0, 0, -1);
    return after(free_discs(law, 1e-3), state, 1).vy[0];
}

}  // namespace

BOOST_AUTO_TEST_CASE(grains_at_exactly_one_diameter_do_not_interact) {
    for (const auto& law : law_variants) {
        BOOST_TEST_CONTEXT(law.name) {
            BOOST_TEST(sliding_speed(law, 2.0) == 1.0);
        }
    }
}

BOOST_AUTO_TEST_CASE(grains_just_below_one_diameter_interact) {
    // The dashpot across the normal acts at any overlap; only the full vector laws have one.
    for (const auto& law : law_variants) {
        BOOST_TEST_CONTEXT(law.name) {
            const bool across = law.damping == dem::DampingDirection::full_vector;
            BOOST_TEST((sliding_speed(law, just_below_two) < 1.0) == across);
        }
    }
}

BOOST_AUTO_TEST_CASE(grains_at_exactly_one_diameter_across_a_period_do_not_interact) {
    for (const auto& law : law_variants) {
        auto p = free_discs(law, 1e-3);
        p.period_x = p.period_y = 8;
        dem::State state;
        add_disc(state, 1, 1, 0, 1);
        add_disc(state, 7, 1, 0, -1);
        add_disc(state, 4, 7, 1, 0);
        add_disc(state, 4, 5, -1, 0);
        const auto end = after(p, state, 1);
        BOOST_TEST_CONTEXT(law.name) {
            BOOST_TEST(end.vy == state.vy, boost::test_tools::per_element());
            BOOST_TEST(end.vx == state.vx, boost::test_tools::per_element());
        }
    }
}

BOOST_AUTO_TEST_CASE(a_grain_whose_point_lies_exactly_on_a_plate_is_not_pushed) {
    auto p = free_discs(law_variants[0], 1e-3);
    p.plate_stiffness = p.stiffness;
    p.plate_reach = 1;
    p.bottom = dem::MovingPlate{.height = 0};
    p.lid = dem::MovingPlate{.height = 8};
    dem::State state;
    add_disc(state, 0, 1, 0, 0);
    add_disc(state, 4, 7, 0, 0);
    const auto end = after(p, state, 100);
    BOOST_TEST(end.y[0] == 1.0);
    BOOST_TEST(end.y[1] == 7.0);
}

BOOST_AUTO_TEST_CASE(free_flight_is_a_straight_line) {
    auto p = free_discs(law_variants[0], 0x1p-10);
    dem::State state;
    add_disc(state, 0, 0, 0.5, -0.25);
    add_disc(state, 10, 0, 0, 0);
    const auto end = after(p, state, 1024);
    BOOST_TEST(end.step == 1024);
    // Every number is a sum of few powers of two: there is nothing to round.
    BOOST_TEST(end.x[0] == 0.5);
    BOOST_TEST(end.y[0] == -0.25);
    BOOST_TEST(end.vx[0] == 0.5);
    BOOST_TEST(end.x[1] == 10.0);
}

BOOST_AUTO_TEST_CASE(no_steps_change_nothing) {
    const auto gas = hot_gas(4, 2.5);
    BOOST_TEST(largest_difference(gas, after(free_discs(law_variants[0], 1e-3), gas, 0)) == 0.0);
}
