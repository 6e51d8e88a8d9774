// A trajectory that is not that of its scene is refused, whatever kind of mistake made it; what
// every code really does passes (the cases of the quick suite run through the same guard).
#include "cases/scene/motion_guard.hpp"
#include "native/base/errors.hpp"
#include "tests/support/kept_frames.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace crossgrain;
using tests::KeptFrame;

namespace {

/// Grains that fly apart and never meet, frames every 0.1; under gravity if asked.
scene::Scene flying(std::size_t grains, double gravity) {
    auto s = tests::head_on_pair();
    s.gravity = gravity;
    s.periodic_x = 1000;
    s.dt = 1e-3;
    s.frame_every = 100;
    s.steps = 1000;
    s.initial = {};
    for (std::size_t i = 0; i < grains; ++i) {
        s.initial.x.push_back(10.0 * double(i));
        s.initial.y.push_back(0);
        s.initial.vx.push_back(1 + 0.1 * double(i));
        s.initial.vy.push_back(0.3);
    }
    return s;
}

/// The exact flight at step 100 k.
KeptFrame in_flight(const scene::Scene& s, int k) {
    const double t = k * 0.1;
    KeptFrame frame(scene::Frame{.step = 100 * k,
                                 .time = t,
                                 .x = s.initial.x,
                                 .y = s.initial.y,
                                 .vx = s.initial.vx,
                                 .vy = s.initial.vy,
                                 .lid = {}});
    for (std::size_t i = 0; i < frame.x.size(); ++i) {
        frame.x[i] += s.initial.vx[i] * t;
        frame.y[i] += s.initial.vy[i] * t - s.gravity / 2 * t * t;
        frame.vy[i] -= s.gravity * t;
    }
    return frame;
}

using Spoil = std::function<void(KeptFrame&, int)>;

std::string answer(const scene::Scene& s, const Spoil& spoil = {}, int frames = 6) {
    scene::MotionGuard guard(s);
    try {
        for (int k = 0; k < frames; ++k) {
            KeptFrame frame = in_flight(s, k);
            if (spoil) spoil(frame, k);
            guard.check(frame.view());
        }
    } catch (const TrajectoryError& error) {
        return error.what();
    }
    return "passed";
}

/// The same above a plate that moves far below and may do work, for all the guard knows.
scene::Scene driven(scene::Scene s) {
    s.plates.stiffness = 500;
    s.plates.bottom = scene::PrescribedPlate{.height = -500, .amplitude = 1, .period = 1};
    return s;
}

bool says(const std::string& answer, const std::string& words) {
    if (answer.find(words) != std::string::npos) return true;
    BOOST_TEST_MESSAGE(answer);
    return false;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_exact_flight_passes) {
    for (const double gravity : {0.0, 1.0})
        BOOST_TEST(answer(flying(5, gravity)) == "passed");
}

BOOST_AUTO_TEST_CASE(another_start_is_refused) {
    const auto s = flying(5, 1);
    BOOST_TEST(says(answer(s, [](auto& f, int) { f.x[3] += 1e-6; }), "x of grain 3"));
    BOOST_TEST(says(answer(s, [](auto& f, int) { f.vy[4] = -f.vy[4]; }), "vy of grain 4"));
    BOOST_TEST(says(answer(s, [](auto& f, int) { std::swap(f.x[0], f.x[1]); }), "x of grain 0"));
    // Of another time: half a step under gravity.
    BOOST_TEST(
        says(answer(s, [&](auto& f, int) { f.vy[0] -= s.gravity * s.dt / 2; }), "vy of grain 0"));
}

BOOST_AUTO_TEST_CASE(grains_that_jump_are_refused) {
    const auto s = flying(5, 1);
    BOOST_TEST(says(answer(s,
                           [](auto& f, int k) {
                               if (k > 2) f.x[1] += 1000;
                           }),
                    "grain 1 moves by"));
    BOOST_TEST(says(answer(s,
                           [](auto& f, int k) {
                               if (k < 3) return;
                               std::swap(f.x[1], f.x[2]);
                               std::swap(f.vx[1], f.vx[2]);
                           }),
                    "grain 1 moves by"));
}

BOOST_AUTO_TEST_CASE(displacements_that_no_velocity_explains_are_refused) {
    for (const double gravity : {0.0, 1.0}) {
        const auto s = driven(flying(5, gravity));
        const auto longer = [&](auto& f, int) {
            for (std::size_t i = 0; i < f.x.size(); ++i)
                f.x[i] += 0.1 * (f.x[i] - s.initial.x[i]);
        };
        BOOST_TEST(says(answer(s, longer), "flies freely"));
        const auto faster = [&](auto& f, int k) {
            if (k == 0) return;
            for (double& v : f.vx)
                v *= 5;
            for (double& v : f.vy)
                v *= 5;
        };
        BOOST_TEST(says(answer(s, faster), "flies freely"));
    }
}

BOOST_AUTO_TEST_CASE(one_coincidence_is_no_finding) {
    const auto s = flying(5, 0);
    // Hit twice between two frames, so that its velocity is the same and its place is not.
    BOOST_TEST(answer(s, [](auto& f, int k) {
                   if (k > 2) f.y[2] += 0.1;
               }) == "passed");
}

BOOST_AUTO_TEST_CASE(grains_within_each_other_are_refused) {
    auto s = flying(2, 0);
    s.initial.x = {0, 1.01};
    s.initial.vx = {0, 0};
    BOOST_TEST(answer(s, {}, 1) == "passed");
    s.initial.x = {0, 0.99};
    BOOST_TEST(says(answer(s, {}, 1), "grains 0 and 1 overlap by 1.01 at step 0"));
    s.initial.frozen = {true, true};
    BOOST_TEST(answer(s, {}, 1) == "passed");
    s.initial.frozen.clear();
    s.contacts = scene::Contacts::lattice_neighbours;
    BOOST_TEST(answer(s, {}, 1) == "passed");
}

BOOST_AUTO_TEST_CASE(energy_from_nowhere_is_refused) {
    const auto s = flying(2, 0);
    const auto kicked = [](double factor) {
        return [factor](auto& f, int k) {
            if (k > 0) f.vx[0] *= factor, f.vx[1] *= factor;
        };
    };
    BOOST_TEST(answer(s, kicked(1.1), 2) == "passed");
    BOOST_TEST(says(answer(s, kicked(2), 2), "the energy has risen"));
    BOOST_TEST(answer(driven(s), kicked(2), 2) == "passed");
}

BOOST_AUTO_TEST_CASE(a_lid_that_moves_as_its_velocity_does_not_is_refused) {
    auto s = tests::free_lid_collision();
    s.gravity = 1;
    s.dt = 1e-3;
    s.frame_every = 100;
    s.steps = 1000;
    s.initial = {.x = {0}, .y = {-50}, .vx = {0}, .vy = {0}};
    s = driven(s);
    auto& lid = std::get<scene::FreeLid>(s.plates.lid);
    lid.height = 5;
    lid.velocity = 2;
    const auto with = [&](double factor) {
        return answer(s, [&](auto& f, int k) {
            const double t = k * 0.1;
            f.lid = scene::LidState{.height = 5 + 2 * t - t * t / 2,
                                    .velocity = (2 - t) * (k == 0 ? 1 : factor)};
        });
    };
    BOOST_TEST(with(1) == "passed");
    BOOST_TEST(says(with(250), "the lid flies freely"));
}

BOOST_AUTO_TEST_CASE(a_step_that_no_contact_survives_is_refused) {
    auto s = flying(2, 0);  // k = 496, m = 1: 2/omega = 2/sqrt(2 k/m) = 0.0635
    s.dt = 0.0634;
    BOOST_TEST(!says(answer(s, {}, 1), "cannot be stable"));
    s.dt = 0.0636;
    BOOST_TEST(says(answer(s, {}, 1), "dt = 0.0636 cannot be stable: a contact of two grains"));
    s.integrator = scene::Integrator::runge_kutta_4;  // sqrt(2) longer
    BOOST_TEST(!says(answer(s, {}, 1), "cannot be stable"));
    s.integrator = scene::Integrator::verlet_half_step;
    s.dt = 1e-3;
    s.grains.diameters = {2, 2};
    s.grains.masses = {1, 1e-4};
    BOOST_TEST(says(answer(s, {}, 1), "two grains needs less than 0.000898"));
}

BOOST_AUTO_TEST_CASE(velocities_that_no_contact_stops_are_refused) {
    auto s = flying(2, 0);
    s.initial.vx[1] = 31.4;  // d/2 sqrt(2 k/m) = 31.5
    BOOST_TEST(answer(s, {}, 1) == "passed");
    s.initial.vx[1] = 31.6;
    BOOST_TEST(says(answer(s, {}, 1), "grain 1 has velocity 31.6"));
}
