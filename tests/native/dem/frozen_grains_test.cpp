// Frozen grains never move, whatever hits them, and are walls of infinite mass to all others.
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

dem::State gas_with_obstacles() {
    auto state = hot_gas(6, 2.5);
    state.frozen = {0, 14, 21, 35};
    for (const auto i : state.frozen)
        state.vx[i] = state.vy[i] = 0;
    return state;
}

/// Restitution of a head-on collision of a grain of mass 1 with a grain that never moves.
dem::State against_frozen(const dem::Parameters& p) {
    dem::State state;
    add_disc(state, 0, 0, 1, 0.25);
    add_disc(state, 2.05, 0.5, 0, 0);
    state.frozen = {1};
    return after(p, state, 400);
}

}  // namespace

BOOST_AUTO_TEST_CASE(frozen_grains_never_move) {
    for (const auto& law : law_variants) {
        for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
            auto p = free_discs(law, 1e-3);
            p.scheme = scheme;
            p.period_x = p.period_y = 15;
            p.gravity = 1;
            const auto start = gas_with_obstacles();
            const auto end = after(p, start, 2000);
            for (const auto i : start.frozen) {
                BOOST_TEST_CONTEXT(law.name << ", grain " << i) {
                    BOOST_TEST(end.x[i] == start.x[i]);
                    BOOST_TEST(end.y[i] == start.y[i]);
                    BOOST_TEST(end.vx[i] == 0.0);
                    BOOST_TEST(end.vy[i] == 0.0);
                }
            }
            BOOST_TEST(largest_difference(start, end) > 1);  // the others did
        }
    }
}

BOOST_AUTO_TEST_CASE(frozen_grains_never_move_even_if_the_state_gives_them_a_velocity) {
    auto start = gas_with_obstacles();
    start.vx[14] = 0.5;
    start.vy[21] = -0.5;
    const auto end = after(free_discs(law_variants[0], 1e-3), start, 100);
    for (const auto i : start.frozen) {
        BOOST_TEST_CONTEXT("grain " << i) {
            BOOST_TEST(end.x[i] == start.x[i]);
            BOOST_TEST(end.y[i] == start.y[i]);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_frozen_grain_is_an_infinite_mass) {
    // The relative motion of two grains of mass 2 has the reduced mass 1: that of a grain of mass 1
    // against one that never moves.
    for (const auto& law : law_variants) {
        for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
            auto p = free_discs(law, 1e-3);
            p.scheme = scheme;
            const auto single = against_frozen(p);
            auto heavy = p;
            heavy.mass = 2;
            dem::State pair;
            add_disc(pair, 0, 0, 0.5, 0.125);
            add_disc(pair, 2.05, 0.5, -0.5, -0.125);
            const auto both = after(heavy, pair, 400);
            BOOST_TEST_CONTEXT(law.name) {
                // 400 roundings; there is nothing chaotic in one collision.
                BOOST_TEST(both.x[0] - both.x[1] == single.x[0] - single.x[1],
                           tt::tolerance(1e-12));
                BOOST_TEST(both.y[0] - both.y[1] == single.y[0] - single.y[1],
                           tt::tolerance(1e-12));
                BOOST_TEST(both.vx[0] - both.vx[1] == single.vx[0], tt::tolerance(1e-11));
                BOOST_TEST(single.vx[0] < -0.3);  // it has bounced
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(an_elastic_gas_between_obstacles_keeps_its_energy) {
    auto p = free_discs(law_variants[0], 1e-3);
    p.damping = 0;
    p.period_x = p.period_y = 15;
    const auto start = gas_with_obstacles();
    const double energy = pair_energy(p, start);
    // (omega dt)^2/8 = 1.2e-4 of what is in contacts.
    BOOST_TEST(pair_energy(p, after(p, start, 1000)) == energy, tt::tolerance(1e-4));
}
