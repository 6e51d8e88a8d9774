// Collisions with a known outcome: restitution, the reversal of the sliding velocity at contact
// when k_t = 2/7 k_n of spheres makes both springs swing alike, and the impulse of gross sliding.
#include "tests/native/friction/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

/// Velocity of grain 0 relative to grain 1 along their common tangent at the point of contact, both
/// of radius 1/2, the normal being that along x.
double sliding_velocity(const friction::State& s) {
    return s.vy[0] - s.vy[1] + 0.5 * (s.omega[0] + s.omega[1]);
}

/// Long enough for the gap and the contact.
friction::State outcome(const friction::Parameters& p, const friction::State& pair) {
    const double contact_time = std::numbers::pi / std::sqrt(2 * p.contact.stiffness);
    return after(p, pair, std::lround((gap + 1.5 * contact_time) / p.dt));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_head_on_collision_has_the_restitution_it_was_made_for) {
    for (const double e : {0.5, 0.8, 1.0}) {
        const auto p = frictional_discs(e, 1e-3, 1000);
        const auto end = outcome(p, colliding_pair(0));
        // Of first order in dt: the dashpot sees half a step's old velocity.
        BOOST_TEST(std::abs(end.vx[1] - end.vx[0] - e) < 2e-3);
        BOOST_TEST(std::abs(end.omega[0]) < 1e-14);
    }
}

BOOST_AUTO_TEST_CASE(a_sticking_elastic_contact_reverses_its_sliding_velocity) {
    // Tangential frequency^2 = k_t (1 + 1/0.4)/m_eff = k_n/m_eff for spheres. Sticks when
    // |v_t| < 7/2 mu v_n. What is left is of the order of the overlap, 3e-4 radii.
    auto p = frictional_discs(1, 1e-3, 1000);
    for (const double sliding : {0.2, -0.8, 1.5}) {
        for (const auto lever : {friction::Lever::radius, friction::Lever::contact_point}) {
            p.contact.conventions.velocity_lever = p.contact.conventions.torque_lever = lever;
            const auto end = outcome(p, colliding_pair(sliding));
            const double limit = lever == friction::Lever::radius ? 2e-3 : 1e-4;
            BOOST_TEST(std::abs(sliding_velocity(end) + sliding) < limit * std::abs(sliding));
            BOOST_TEST(std::abs(end.vx[1] - 1) < 1e-3);
        }
    }
    // Of a disc the two springs do not swing alike: the judge notices.
    p.inertia_factor = disc;
    BOOST_TEST(std::abs(sliding_velocity(outcome(p, colliding_pair(0.2))) + 0.2) > 5e-3);
}

BOOST_AUTO_TEST_CASE(gross_sliding_takes_mu_times_the_normal_impulse) {
    // Delta v_t = mu (1 + e) v_n of the centres, to the 1 % by which the spring loads first and an
    // attractive tail has friction too.
    for (const double e : {0.8, 1.0}) {
        for (const auto tail : {friction::AttractiveTail::kept, friction::AttractiveTail::cut}) {
            // Short contacts: the normal must not turn.
            auto p = frictional_discs(e, 1e-5, 1000);
            p.contact.tail = tail;
            for (const auto force :
                 {friction::TangentialForce::spring, friction::TangentialForce::dashpot}) {
                p.contact.tangential = force;
                p.contact.tangential_damping =
                    force == friction::TangentialForce::dashpot ? 1e6 : 0;
                const auto end = outcome(p, colliding_pair(-8));
                const double lost = end.vy[0] - end.vy[1] + 8;
                const double expected = 0.5 * (1 + end.vx[1] - end.vx[0]);
                BOOST_TEST(std::abs(lost - expected) < 0.01 * expected);
                // Both get the same spin, from 2 J r/I = lost/(2 0.4 r).
                BOOST_TEST(std::abs(end.omega[0] - end.omega[1]) < 1e-10);
                BOOST_TEST(std::abs(end.omega[0] - lost / (2 * 0.4 * 0.5)) < 1e-3 * lost);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(damping_per_effective_mass_gives_all_pairs_the_same_restitution) {
    // k differs per pair's mass, so that only eta = rate m_eff keeps ln e/t_col; with frozen
    // partners the mass is that of the mobile grain.
    auto p = frictional_discs(0.7, 1e-3, 1000);
    p.contact.damping_scale = friction::DampingScale::effective_mass;
    const double rate = 2 * p.contact.damping;
    p.contact.damping = rate;
    for (const bool frozen : {false, true}) {
        auto pair = colliding_pair(0, 0.6);
        if (frozen) pair.frozen = {1};
        const double m2 = pair.mass[1];
        const double effective = frozen ? 1 : m2 / (1 + m2);
        const double half_rate = rate / 2;
        const double omega = std::sqrt(p.contact.stiffness / effective - half_rate * half_rate);
        const double e = std::exp(-half_rate * std::numbers::pi / omega);
        const auto end = after(p, pair, 4000);
        BOOST_TEST(std::abs(end.vx[1] - end.vx[0] - e) < 2e-3);
    }
}

BOOST_AUTO_TEST_CASE(a_free_grain_falls_and_drag_slows_it) {
    auto p = frictional_discs(0.8, 0.01, 100);
    p.gravity = 2;
    p.drag = 0.5;
    friction::State s;
    add(s, {.x = 0, .y = 0, .vx = 3, .vy = 0, .omega = 4, .mass = 2});
    const auto end = after(p, s, 10000);
    // v_x = v_0 exp(-c t/m), v_y = -m g/c (1 - exp(-c t/m)); spins feel no drag.
    const double decay = std::exp(-0.5 * 1.0 / 2);
    BOOST_TEST(std::abs(end.vx[0] - 3 * decay) < 1e-4);
    BOOST_TEST(std::abs(end.vy[0] + 2 * 2 / 0.5 * (1 - decay)) < 1e-4);
    BOOST_TEST(end.omega[0] == 4.0);
}

BOOST_AUTO_TEST_CASE(backing_planes_are_springs_on_centres) {
    auto p = frictional_discs(0.8, 0.1, 1000);
    p.backing = friction::BackingPlanes{.stiffness = 400, .left = -1, .right = 1};
    friction::State s;
    add(s, {.x = 0.9, .y = 0, .vx = 2, .vy = 0});
    add(s, {.x = -0.9, .y = 5, .vx = -2, .vy = 0, .omega = 1});
    // 0.05 to the plane, pi/20 behind it, back again at the same speed.
    const auto end = after(p, s, std::lround((0.05 + std::numbers::pi / 20 + 0.02) / p.dt));
    BOOST_TEST(std::abs(end.vx[0] + 2) < 1e-4);
    BOOST_TEST(std::abs(end.vx[1] - 2) < 1e-4);
    BOOST_TEST(end.omega[1] == 1.0);
}
