// The engine knows no left and right, no up and down, no rest frame and no history of its calls.
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

// A gas adds the forces on a grain in the order of the cells, which a mirror changes: round-off of
// 1e-15, grown by a factor of 10 to 30 in each of the two or three collisions of these runs.
constexpr double grown_round_off = 1e-11;
constexpr std::int64_t steps = 300;

template <class Mirror>
dem::State mirrored(dem::State state, Mirror mirror) {
    mirror(state);
    return state;
}

void negate(std::vector<double>& values) {
    for (double& value : values)
        value = -value;
}
const auto left_right = [](dem::State& s) { negate(s.x), negate(s.vx); };
const auto up_down = [](dem::State& s) {
    negate(s.y), negate(s.vy);
    s.lid_height = -s.lid_height, s.lid_velocity = -s.lid_velocity;
};
const auto diagonal = [](dem::State& s) { std::swap(s.x, s.y), std::swap(s.vx, s.vy); };

dem::State oblique_pair() {
    dem::State state;
    add_disc(state, -1.05, 0.35, 1.5, 0.2);
    add_disc(state, 1.0, -0.4, -0.5, 0.1);
    return state;
}

/// Largest difference between mirroring before and after the run.
template <class Mirror>
double asymmetry(const dem::Parameters& p, const dem::State& start, Mirror mirror) {
    return largest_difference(mirrored(after(p, start, steps), mirror),
                              after(p, mirrored(start, mirror), steps));
}

template <class Check>
void for_every_law(Check check) {
    for (const auto& law : law_variants) {
        for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
            auto p = free_discs(law, 1e-3);
            p.scheme = scheme;
            BOOST_TEST_CONTEXT(law.name) {
                check(p);
            }
        }
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_mirrored_pair_collides_in_the_mirror_bit_for_bit) {
    for_every_law([](const dem::Parameters& p) {
        BOOST_TEST(asymmetry(p, oblique_pair(), left_right) == 0.0);
        BOOST_TEST(asymmetry(p, oblique_pair(), up_down) == 0.0);
        BOOST_TEST(asymmetry(p, oblique_pair(), diagonal) == 0.0);
        BOOST_TEST(largest_difference(after(p, oblique_pair(), steps), oblique_pair()) > 0.1);
    });
}

BOOST_AUTO_TEST_CASE(a_mirrored_gas_moves_in_the_mirror) {
    for_every_law([](dem::Parameters p) {
        p.period_x = p.period_y = 15;
        BOOST_TEST(asymmetry(p, hot_gas(6, 2.5), left_right) < grown_round_off);
        BOOST_TEST(asymmetry(p, hot_gas(6, 2.5), up_down) < grown_round_off);
        BOOST_TEST(asymmetry(p, hot_gas(6, 2.5), diagonal) < grown_round_off);
    });
}

BOOST_AUTO_TEST_CASE(a_bed_s_left_is_its_right) {
    for_every_law([](dem::Parameters p) {
        p.period_x = 15;
        p.gravity = 1;
        p.plate_stiffness = p.stiffness;
        p.bottom = dem::MovingPlate{.height = 0, .amplitude = 0.5, .omega = 3};
        p.lid = dem::InertialLid{.mass = 5};
        auto bed = hot_gas(6, 2.5);
        bed.lid_height = 15;
        BOOST_TEST(asymmetry(p, bed, left_right) < grown_round_off);
    });
}

BOOST_AUTO_TEST_CASE(a_lid_is_a_bottom_upside_down) {
    for_every_law([](dem::Parameters p) {
        p.plate_stiffness = p.stiffness;
        p.plate_reach = 1;
        dem::State grain;
        add_disc(grain, 0, 1.2, 0.3, -2);
        auto q = p;
        p.bottom = dem::MovingPlate{.height = -0.25, .amplitude = 0.5, .omega = 3};
        q.lid = dem::MovingPlate{.height = 0.25, .amplitude = -0.5, .omega = 3};
        const auto on_bottom = after(p, grain, steps);
        const auto on_lid = after(q, mirrored(grain, up_down), steps);
        BOOST_TEST(on_bottom.vy[0] > 1);  // it has bounced
        BOOST_TEST(largest_difference(mirrored(on_bottom, up_down), on_lid) == 0.0);
    });
}

BOOST_AUTO_TEST_CASE(a_moving_observer_sees_the_same_gas) {
    constexpr double ux = 1.7, uy = -2.3;
    for_every_law([](dem::Parameters p) {
        p.period_x = p.period_y = 15;
        const auto gas = hot_gas(6, 2.5);
        auto boosted = gas;
        for (std::size_t i = 0; i < gas.x.size(); ++i) {
            boosted.vx[i] += ux;
            boosted.vy[i] += uy;
        }
        auto seen = after(p, boosted, steps);
        for (std::size_t i = 0; i < gas.x.size(); ++i) {
            seen.x[i] -= ux * p.dt * steps;
            seen.y[i] -= uy * p.dt * steps;
            seen.vx[i] -= ux;
            seen.vy[i] -= uy;
        }
        BOOST_TEST(largest_difference(seen, after(p, gas, steps)) < grown_round_off);
    });
}

BOOST_AUTO_TEST_CASE(a_box_has_no_preferred_origin) {
    for_every_law([](dem::Parameters p) {
        p.period_x = p.period_y = 15;
        const auto gas = hot_gas(6, 2.5);
        auto shifted = gas;
        for (std::size_t i = 0; i < gas.x.size(); ++i) {
            shifted.x[i] += 15 * static_cast<double>(i % 5) - 22.125;
            shifted.y[i] -= 15 * static_cast<double>(i % 3) + 3.75;
        }
        auto seen = after(p, shifted, steps);
        for (std::size_t i = 0; i < gas.x.size(); ++i) {
            seen.x[i] -= 15 * static_cast<double>(i % 5) - 22.125;
            seen.y[i] += 15 * static_cast<double>(i % 3) + 3.75;
        }
        // Positions of order 50 instead of 10 lose another digit at the start.
        BOOST_TEST(largest_difference(seen, after(p, gas, steps)) < 10 * grown_round_off);
    });
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_bits_however_the_run_is_cut) {
    for_every_law([](dem::Parameters p) {
        p.period_x = p.period_y = 15;
        const auto once = after(p, hot_gas(6, 2.5), 1000);
        BOOST_TEST(largest_difference(once, after(p, hot_gas(6, 2.5), 1000)) == 0.0);
        dem::Engine engine(p, hot_gas(6, 2.5));
        for (const std::int64_t piece : {1, 2, 0, 7, 490, 500})
            engine.advance(piece);
        BOOST_TEST(engine.state().step == 1000);
        BOOST_TEST(largest_difference(once, engine.state()) == 0.0);
        BOOST_TEST(largest_difference(once, after(p, hot_gas(6, 2.5, 2), 1000)) > 0.1);
    });
}
