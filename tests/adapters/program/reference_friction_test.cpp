// The reference that codes with friction are held against is itself held against closed forms, and
// against what is known of each convention: which quantities it conserves, and which not.
#include "tests/support/frictional_scenes.hpp"
#include "tests/support/reference_friction.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

scene::FrictionConventions named(const std::string& name) {
    return scene::conventions_named(name).value();
}

/// Two equal spheres that meet at the origin with unit approach speed and tangential speed `slip`,
/// `harder` times as stiff as the usual ones.
scene::Scene collision(double slip, scene::ContactLaw law, double harder = 1) {
    const double shorter = 1 / std::sqrt(harder);
    auto scene = empty_scene("collision", 1e-4 * shorter, 0.2 * shorter);
    law.stiffness *= harder;
    law.damping *= std::sqrt(harder);
    law.friction->stiffness *= harder;
    scene.contact = law;
    const double x = 1 + 0.01 * shorter;
    add_disc(scene, {-x, 0}, {0.5, slip / 2}, 0, 2.0);
    add_disc(scene, {x, 0}, {-0.5, -slip / 2}, 0, 2.0);
    return scene;
}

scene::ContactLaw elastic() {
    auto law = frictional_law();
    law.damping = 0;
    return law;
}

/// Energy and angular momentum before and after.
struct Balance {
    double energy_gain, angular_momentum_gain;
};

Balance balance(const scene::Scene& scene, const scene::FrictionConventions& conventions) {
    ReferenceFriction run(scene, conventions);
    const double energy = run.kinetic_energy(), momentum = run.angular_momentum();
    run.run([](const scene::Frame&) {});
    return {run.kinetic_energy() / energy - 1, run.angular_momentum() / momentum - 1};
}

struct Outcome {
    double relative_velocity;  ///< along the tangent, of the centres
    double slip;               ///< the same at the point of contact
};

Outcome outcome(const scene::Scene& scene, const scene::FrictionConventions& conventions) {
    Outcome found{};
    ReferenceFriction(scene, conventions).run([&](const scene::Frame& frame) {
        const double dx = frame.x[0] - frame.x[1], dy = frame.y[0] - frame.y[1];
        const double r = std::hypot(dx, dy);
        found.relative_velocity =
            (-(frame.vx[0] - frame.vx[1]) * dy + (frame.vy[0] - frame.vy[1]) * dx) / r;
        found.slip = found.relative_velocity - frame.omega[0] - frame.omega[1];
    });
    return found;
}

}  // namespace

/// Elastic spheres whose tangential spring is 2/7 of the normal one, so that both swing alike: the
/// velocity at the point of contact is turned round. To the order of the overlap.
BOOST_AUTO_TEST_CASE(a_contact_that_sticks_turns_the_slip_round) {
    // They meet with the tangential velocity (v_i - v_j) . (0, -1).
    const double before = -0.5;
    const auto scene = collision(0.5, elastic(), 1e4);
    for (const auto* name : {"liggghts", "yade", "lammps-granular", "lammps-hooke-history"}) {
        BOOST_TEST(std::abs(outcome(scene, named(name)).slip / before + 1) < 0.01, name);
    }
}

/// Sliding all the time, the tangential impulse is mu times the normal one: (1 + e) m/2.
BOOST_AUTO_TEST_CASE(a_contact_that_slides_loses_mu_times_the_normal_impulse) {
    auto law = frictional_law(0, scene::Clipping::normal_only);
    const auto scene = collision(8, law, 1e6);
    const double lost = std::abs(-8 - outcome(scene, named("yade")).relative_velocity);
    BOOST_TEST(std::abs(lost / (0.5 * 1.8) - 1) < 0.01, lost);
}

BOOST_AUTO_TEST_CASE(what_each_convention_conserves) {
    const auto scene = collision(1, elastic());
    for (const auto* name : {"liggghts", "yade"}) {
        const auto gain = balance(scene, named(name));
        BOOST_TEST(std::abs(gain.angular_momentum_gain) < 1e-12, name);
    }
    // One arm for velocity and torque conserves energy while the contact sticks, but an arm that is
    // longer than the way to the contact makes angular momentum of nothing.
    const auto hooke = balance(scene, named("lammps-hooke-history"));
    BOOST_TEST(std::abs(hooke.angular_momentum_gain) > 1e-3);
    const auto granular = balance(scene, named("lammps-granular"));
    BOOST_TEST(std::abs(granular.angular_momentum_gain) < 1e-12);
}

/// Each choice is seen in a collision of moderate overlap: a reference that ignored one would be
/// blind to it.
BOOST_AUTO_TEST_CASE(every_choice_changes_the_outcome) {
    const auto scene = collision(1.5, frictional_law(5));
    const auto usual = named("liggghts");
    const double slip = outcome(scene, usual).slip;
    const auto changes = [&](const scene::FrictionConventions& other) {
        return std::abs(outcome(scene, other).slip - slip);
    };
    auto other = usual;
    other.velocity_lever = scene::Lever::radius;
    BOOST_TEST(changes(other) > 1e-4);
    other = usual;
    other.torque_lever = scene::Lever::radius;
    BOOST_TEST(changes(other) > 1e-4);
    other = usual;
    other.limit = scene::CoulombLimit::total;
    BOOST_TEST(changes(other) > 1e-4);
    for (const auto rotation :
         {scene::SpringRotation::rotate, scene::SpringRotation::project_and_rescale}) {
        other = usual;
        other.rotation = rotation;
        BOOST_TEST(changes(other) > 1e-10);
    }
}

/// Were it not, the scene would say nothing of planes.
BOOST_AUTO_TEST_CASE(in_the_small_pipe_a_backing_plane_is_touched) {
    auto pipe = pipe_in_small(frictional_law(), 1e-3);
    pipe.frame_every = 1;  // the grain is soon back
    double farthest_left = 0;
    ReferenceFriction(pipe, named("yade")).run([&](const scene::Frame& frame) {
        farthest_left = std::min(farthest_left, frame.x.back());
    });
    BOOST_TEST(farthest_left < pipe.backing->left - 0.1);
}
