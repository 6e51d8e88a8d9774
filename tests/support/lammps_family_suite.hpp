// Test cases for LAMMPS and its fork LIGGGHTS: real runs, each against the reference integrator
// and, where there is one, a closed form. The test program of each code includes this once and
// defines `code_under_test`.
#pragma once

#include "adapters/code.hpp"
#include "native/base/errors.hpp"
#include "tests/support/adapter_run.hpp"
#include "tests/support/parity.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace crossgrain::tests {

[[nodiscard]] const adapters::GrainCode& code_under_test();

inline std::vector<KeptFrame> check(const scene::Scene& scene) {
    return check_parity(code_under_test(), scene);
}

using scene::Clipping;
using scene::Damping;
using scene::PlateContact;

BOOST_AUTO_TEST_CASE(head_on_pair_has_the_restitution_of_the_law) {
    const auto frames = check(head_on_pair());
    const double e = frames.back().vx[1] - frames.back().vx[0];
    BOOST_TEST(std::abs(e - 0.8) < 5e-4);  // the scheme's error at dt = t_col/1000
    // Cut at zero force, the pair keeps what the attraction would take away.
    const auto clipped = check(with_law(head_on_pair(), Damping::full_vector, Clipping::all));
    const double e_clipped = clipped.back().vx[1] - clipped.back().vx[0];
    BOOST_TEST(std::abs(e_clipped - 0.80809934) < 5e-4);
}

BOOST_AUTO_TEST_CASE(oblique_pair_in_every_law) {
    for (const double dt : {1e-3, 1e-4}) {
        const auto pair = oblique_pair(dt);
        check(pair);
        check(with_law(pair, Damping::normal_only, Clipping::none));
        check(with_law(pair, Damping::normal_only, Clipping::all));
        check(with_law(pair, Damping::normal_only, Clipping::normal_only));
        // The force is cut as a whole, which is what `all` means.
        check(with_law(pair, Damping::full_vector, Clipping::all));
    }
}

BOOST_AUTO_TEST_CASE(bounce_on_a_plate_lasts_pi_over_omega) {
    for (const auto touches : {PlateContact::centre, PlateContact::surface}) {
        check(bounce_on_bottom(touches));
        auto weightless = bounce_on_bottom(touches);
        weightless.gravity = 0;
        const auto frames = check(weightless);
        const double travelled = frames.back().y[0] - frames.front().y[0] + 0.3;
        const double duration =
            contact_duration(frames.back().time, 0.3, travelled, frames.back().vy[0]);
        // Second order in dt: (dt omega)^2 / 24.
        BOOST_TEST(std::abs(duration - std::numbers::pi / std::sqrt(stiffness)) < 1e-5);
        BOOST_TEST(std::abs(frames.back().vy[0] - 1.0) < 1e-4);
    }
}

BOOST_AUTO_TEST_CASE(collision_with_a_free_lid) {
    const auto frames = check(free_lid_collision());
    const auto& last = frames.back();
    // Elastic, masses 1 and 3: speeds 1, 0 become -1/2, 1/2.
    BOOST_TEST(std::abs(last.vy[0] + 0.5) < 1e-4);
    BOOST_TEST(std::abs(last.vy[0] + 3.0 * last.lid->velocity - 1.0) < 1e-12);
    // Both positions give the time at which they parted; touched at t = 0.3, and the centre of mass
    // (speed 1/4) tells where.
    const double gap = last.lid->height - last.y[0];
    const double duration = contact_duration(last.time, 0.3, gap, 1.0);
    BOOST_TEST(std::abs(duration - std::numbers::pi / std::sqrt(stiffness * (4.0 / 3.0))) < 1e-5);
}

BOOST_AUTO_TEST_CASE(moving_plates) {
    for (const double dt : {1e-3, 1e-4}) {
        check(moving_bottom(dt));
        check(prescribed_lid(dt));
    }
}

BOOST_AUTO_TEST_CASE(vibrated_bed) {
    for (const double dt : {1e-3, 1e-4}) {
        check(small_bed(dt));
        check(bed_with_obstacle(dt));
    }
}

BOOST_AUTO_TEST_CASE(frozen_grain_does_not_change_the_law) {
    const auto frames = check(frozen_target());
    BOOST_TEST(frames.back().x[1] == frames.front().x[1]);
    BOOST_TEST(frames.back().vx[1] == 0.0);
}

BOOST_AUTO_TEST_CASE(gases) {
    check(small_gas());
    check(doubly_periodic_gas());
    check(heavy_small_gas());
    auto elastic = small_gas();
    elastic.name = "elastic-gas";
    elastic.contact.damping = 0;
    check(elastic);
}

BOOST_AUTO_TEST_CASE(what_neither_code_can_express_is_said) {
    auto predicted = head_on_pair();
    predicted.integrator = scene::Integrator::verlet_predicted;
    BOOST_TEST(code_under_test().cannot_express(predicted).has_value());
    const auto pair = oblique_pair();
    BOOST_TEST(code_under_test()
                   .cannot_express(with_law(pair, Damping::full_vector, Clipping::normal_only))
                   .has_value());
}

BOOST_AUTO_TEST_CASE(input_holds_no_more_model_than_the_scene_needs) {
    const auto input = code_under_test().input(head_on_pair());
    BOOST_TEST_REQUIRE(input.size() == 2u);
    for (const auto* word : {"gravity", "wall", "addforce", "variable", "lid", "nve/sphere",
                             "atom_modify", "exclude"}) {
        BOOST_TEST(input[0].text.find(word) == std::string::npos, "holds '" << word << "'");
    }
    BOOST_TEST(input[1].text.find("1 atom types") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(absurd_time_step_is_an_error_with_a_reason) {
    for (const double dt : {0.2, 10.0}) {
        auto scene = small_bed();
        scene.dt = dt;
        scene.steps = 2000;
        scene.frame_every = 10;
        const auto start = std::chrono::steady_clock::now();
        BOOST_CHECK_EXCEPTION((void)frames_of(code_under_test(), scene, 30), AdapterError,
                              [](const AdapterError& error) {
                                  BOOST_TEST_MESSAGE(error.details().reason
                                                     << " | " << error.details().exit);
                                  return !error.details().reason.empty();
                              });
        BOOST_TEST((std::chrono::steady_clock::now() - start < std::chrono::seconds(30)));
    }
}

}  // namespace crossgrain::tests
