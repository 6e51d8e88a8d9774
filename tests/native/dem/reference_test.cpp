// The engine against a plain O(N^2) integrator written from the formulas: every law, both schemes,
// plates, a free lid, obstacles and periods, to round-off.
#include "native/dem/engine.hpp"
#include "tests/support/kept_frames.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace crossgrain;
using tests::KeptFrame;

namespace {

// Round-off of 1e-15 and the few collisions of these short runs.
constexpr double limit = 2e-12;

dem::MovingPlate plate(const scene::PrescribedPlate& given) {
    return {.height = given.height,
            .amplitude = given.amplitude,
            .omega = 2 * std::numbers::pi / given.period};
}

dem::AttractiveTail tail(scene::Clipping clipping) {
    switch (clipping) {
    case scene::Clipping::all:
        return dem::AttractiveTail::contact_force_cut;
    case scene::Clipping::normal_only:
        return dem::AttractiveTail::normal_force_cut;
    case scene::Clipping::none:
        break;
    }
    return dem::AttractiveTail::kept;
}

dem::Parameters parameters(const scene::Scene& s) {
    const bool full = s.contact.damping_acts_on == scene::Damping::full_vector;
    const bool predicted = s.integrator == scene::Integrator::verlet_predicted;
    const bool surface = s.plates.touches == scene::PlateContact::surface;
    dem::Parameters p{.diameter = s.grains.diameter,
                      .mass = s.grains.mass,
                      .stiffness = s.contact.stiffness,
                      .damping = s.contact.damping,
                      .damping_direction = full ? dem::DampingDirection::full_vector
                                                : dem::DampingDirection::normal_only,
                      .tail = tail(s.contact.clipping),
                      .gravity = s.gravity,
                      .period_x = s.periodic_x,
                      .period_y = s.periodic_y,
                      .plate_stiffness = s.plates.stiffness,
                      .plate_reach = surface ? s.grains.diameter / 2 : 0,
                      .scheme =
                          predicted ? dem::Scheme::verlet_predicted : dem::Scheme::verlet_half_step,
                      .dt = s.dt};
    if (s.plates.bottom) p.bottom = plate(*s.plates.bottom);
    if (const auto* lid = std::get_if<scene::PrescribedPlate>(&s.plates.lid)) p.lid = plate(*lid);
    if (const auto* lid = std::get_if<scene::FreeLid>(&s.plates.lid)) {
        p.lid = dem::InertialLid{lid->mass};
    }
    return p;
}

std::vector<KeptFrame> engine_frames(const scene::Scene& s) {
    dem::State start{
        .x = s.initial.x, .y = s.initial.y, .vx = s.initial.vx, .vy = s.initial.vy, .frozen = {}};
    for (std::size_t i = 0; i < s.initial.frozen.size(); ++i) {
        if (s.initial.frozen[i]) start.frozen.push_back(i);
    }
    if (const auto* lid = std::get_if<scene::FreeLid>(&s.plates.lid)) {
        start.lid_height = lid->height;
        start.lid_velocity = lid->velocity;
    }
    dem::Engine engine(parameters(s), std::move(start));
    std::vector<KeptFrame> frames;
    for (std::int64_t step = 0; step <= s.steps; step += s.frame_every) {
        engine.advance(step - engine.state().step);
        const auto& now = engine.state();
        scene::Frame frame{.step = now.step,
                           .time = static_cast<double>(now.step) * s.dt,
                           .x = now.x,
                           .y = now.y,
                           .vx = now.vx,
                           .vy = now.vy,
                           .lid = {}};
        if (s.has_free_lid()) frame.lid = scene::LidState{now.lid_height, now.lid_velocity};
        frames.emplace_back(frame);
    }
    return frames;
}

void check(scene::Scene s) {
    for (const auto damping : {scene::Damping::full_vector, scene::Damping::normal_only}) {
        for (const auto clipping :
             {scene::Clipping::none, scene::Clipping::all, scene::Clipping::normal_only}) {
            for (const auto integrator :
                 {scene::Integrator::verlet_half_step, scene::Integrator::verlet_predicted}) {
                s.contact.damping_acts_on = damping;
                s.contact.clipping = clipping;
                s.integrator = integrator;
                const double difference =
                    tests::largest_difference(engine_frames(s), tests::reference_frames(s));
                BOOST_TEST_CONTEXT(s.name << ", " << to_string(damping) << ", "
                                          << to_string(clipping) << ", " << to_string(integrator)) {
                    BOOST_TEST(difference < limit);
                }
            }
        }
    }
}

constexpr double dt = 5e-4;

}  // namespace

BOOST_AUTO_TEST_CASE(collisions_are_the_reference_s) {
    check(tests::head_on_pair(dt));
    check(tests::oblique_pair(dt));
    check(tests::frozen_target(dt));
}

BOOST_AUTO_TEST_CASE(plates_are_the_reference_s) {
    check(tests::bounce_on_bottom(scene::PlateContact::centre, dt));
    check(tests::bounce_on_bottom(scene::PlateContact::surface, dt));
    check(tests::moving_bottom(dt));
    check(tests::prescribed_lid(dt));
    check(tests::free_lid_collision(dt));
}

BOOST_AUTO_TEST_CASE(gases_are_the_reference_s) {
    check(tests::small_gas(dt));
    check(tests::doubly_periodic_gas(dt));
    check(tests::heavy_small_gas(dt));
}

BOOST_AUTO_TEST_CASE(beds_are_the_reference_s) {
    check(tests::small_bed(dt));
    auto bed = tests::bed_with_obstacle(dt);
    for (std::size_t i = 0; i < bed.grain_count(); ++i) {
        if (bed.initial.frozen[i]) bed.initial.vx[i] = bed.initial.vy[i] = 0;
    }
    check(bed);
}

BOOST_AUTO_TEST_CASE(a_bed_whose_frozen_grains_are_given_a_velocity_is_the_reference_s) {
    check(tests::bed_with_obstacle(dt));
}
