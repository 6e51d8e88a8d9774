// Real runs of LAMMPS, each against the reference integrator and, where there is one, a closed
// form.
#include "adapters/lammps/lammps_code.hpp"
#include "native/base/errors.hpp"
#include "tests/support/external_code.hpp"
#include "tests/support/parity.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <cmath>
#include <numbers>

using namespace crossgrain;
using adapters::LammpsCode;
using scene::Clipping;
using scene::Damping;
using scene::PlateContact;
using tests::check_parity;
using tests::with_law;

using NeedsLammps = tests::NeedsCode<LammpsCode>;
BOOST_TEST_GLOBAL_FIXTURE(NeedsLammps);

namespace {
const LammpsCode code;
}

BOOST_AUTO_TEST_CASE(version_is_what_the_program_says) {
    const auto availability = code.probe();
    BOOST_TEST_MESSAGE("LAMMPS " << availability.version);
    // "29 Sep 2021 - Update 2" or "2 Aug 2023"
    BOOST_TEST(availability.version.find(" 20") != std::string::npos);
    BOOST_TEST(availability.reason.empty());
    const auto missing = LammpsCode("crossgrain-no-such-lmp").probe();
    BOOST_TEST(!missing.installed);
    BOOST_TEST(missing.reason == "no 'crossgrain-no-such-lmp' on PATH");
}

BOOST_AUTO_TEST_CASE(head_on_pair_has_the_restitution_of_the_law) {
    const auto frames = check_parity(code, tests::head_on_pair());
    const double e = frames.back().vx[1] - frames.back().vx[0];
    BOOST_TEST(std::abs(e - 0.8) < 5e-4);  // the scheme's error at dt = t_col/1000
    // Cut at zero force, the pair keeps what the attraction would take away.
    const auto clipped =
        check_parity(code, with_law(tests::head_on_pair(), Damping::full_vector, Clipping::all));
    const double e_clipped = clipped.back().vx[1] - clipped.back().vx[0];
    BOOST_TEST(std::abs(e_clipped - 0.80809934) < 5e-4);
}

BOOST_AUTO_TEST_CASE(oblique_pair_in_every_law) {
    for (const double dt : {1e-3, 1e-4}) {
        const auto pair = tests::oblique_pair(dt);
        check_parity(code, pair);
        check_parity(code, with_law(pair, Damping::normal_only, Clipping::none));
        check_parity(code, with_law(pair, Damping::normal_only, Clipping::all));
        check_parity(code, with_law(pair, Damping::normal_only, Clipping::normal_only));
        // limit_damping cuts the tangential dashpot too, which is what `all` means.
        check_parity(code, with_law(pair, Damping::full_vector, Clipping::all));
    }
}

BOOST_AUTO_TEST_CASE(bounce_on_a_plate_lasts_pi_over_omega) {
    for (const auto touches : {PlateContact::centre, PlateContact::surface}) {
        check_parity(code, tests::bounce_on_bottom(touches));
        auto weightless = tests::bounce_on_bottom(touches);
        weightless.gravity = 0;
        const auto frames = check_parity(code, weightless);
        const double travelled = frames.back().y[0] - frames.front().y[0] + 0.3;
        const double duration =
            tests::contact_duration(frames.back().time, 0.3, travelled, frames.back().vy[0]);
        // Second order in dt: (dt omega)^2 / 24.
        BOOST_TEST(std::abs(duration - std::numbers::pi / std::sqrt(tests::stiffness)) < 1e-5);
        BOOST_TEST(std::abs(frames.back().vy[0] - 1.0) < 1e-4);
    }
}

BOOST_AUTO_TEST_CASE(collision_with_a_free_lid) {
    const auto frames = check_parity(code, tests::free_lid_collision());
    const auto& last = frames.back();
    // Elastic, masses 1 and 3: speeds 1, 0 become -1/2, 1/2.
    BOOST_TEST(std::abs(last.vy[0] + 0.5) < 1e-4);
    BOOST_TEST(std::abs(last.vy[0] + 3.0 * last.lid->velocity - 1.0) < 1e-12);
    // Both positions give the time at which they parted; touched at t = 0.3, and the centre of mass
    // (speed 1/4) tells where.
    const double gap = last.lid->height - last.y[0];
    const double duration = tests::contact_duration(last.time, 0.3, gap, 1.0);
    BOOST_TEST(std::abs(duration - std::numbers::pi / std::sqrt(tests::stiffness * (4.0 / 3.0))) <
               1e-5);
}

BOOST_AUTO_TEST_CASE(moving_plates) {
    for (const double dt : {1e-3, 1e-4}) {
        check_parity(code, tests::moving_bottom(dt));
        check_parity(code, tests::prescribed_lid(dt));
    }
}

BOOST_AUTO_TEST_CASE(vibrated_bed) {
    for (const double dt : {1e-3, 1e-4}) {
        check_parity(code, tests::small_bed(dt));
        check_parity(code, tests::bed_with_obstacle(dt));
    }
}

BOOST_AUTO_TEST_CASE(frozen_grain_does_not_change_the_law) {
    const auto frames = check_parity(code, tests::frozen_target());
    BOOST_TEST(frames.back().x[1] == frames.front().x[1]);
    BOOST_TEST(frames.back().vx[1] == 0.0);
}

BOOST_AUTO_TEST_CASE(gases) {
    check_parity(code, tests::small_gas());
    check_parity(code, tests::doubly_periodic_gas());
    check_parity(code, tests::heavy_small_gas());
    auto elastic = tests::small_gas();
    elastic.name = "elastic-gas";
    elastic.contact.damping = 0;
    check_parity(code, elastic);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_expressed_is_said) {
    auto predicted = tests::head_on_pair();
    predicted.integrator = scene::Integrator::verlet_predicted;
    BOOST_TEST(code.cannot_express(predicted).has_value());
    const auto pair = tests::oblique_pair();
    BOOST_TEST(code.cannot_express(with_law(pair, Damping::full_vector, Clipping::normal_only))
                   .has_value());
    auto spinning = pair;
    spinning.contact.spins = scene::Spins::on;
    BOOST_TEST(code.cannot_express(spinning).has_value());
    // Without a tangential dashpot nothing turns a grain.
    check_parity(code, with_law(spinning, Damping::normal_only, Clipping::none));
}

BOOST_AUTO_TEST_CASE(input_holds_no_more_model_than_the_scene_needs) {
    const auto input = code.input(tests::head_on_pair());
    BOOST_TEST_REQUIRE(input.size() == 2u);
    for (const auto* word :
         {"gravity", "wall", "variable", "lid", "nve/sphere", "atom_modify", "exclude"}) {
        BOOST_TEST(input[0].text.find(word) == std::string::npos, "holds '" << word << "'");
    }
    BOOST_TEST(input[1].text.find("1 atom types") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(absurd_time_step_is_an_error_with_a_reason) {
    for (const double dt : {0.2, 10.0}) {
        auto scene = tests::small_bed();
        scene.dt = dt;
        scene.steps = 2000;
        scene.frame_every = 10;
        const auto start = std::chrono::steady_clock::now();
        BOOST_CHECK_EXCEPTION(
            (void)tests::frames_of(code, scene, 30), AdapterError, [](const AdapterError& error) {
                BOOST_TEST_MESSAGE(error.details().reason << " | " << error.details().exit);
                return !error.details().reason.empty();
            });
        BOOST_TEST((std::chrono::steady_clock::now() - start < std::chrono::seconds(30)));
    }
}
