// A scene file says all that a code must decide, and what it says arrives in the scene.
#include "tests/cases/scene/scene_text.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::scene;
using tests::replaced;
using tests::scene_text;

namespace {

Scene with(const std::string& what, const std::string& by) {
    return tests::read_scene(replaced(scene_text, what, by));
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_key_of_the_file_arrives_in_the_scene) {
    const auto s = tests::read_scene(scene_text, 42);
    BOOST_TEST(s.name == "test");
    BOOST_TEST(s.seed == 42u);
    BOOST_TEST(s.gravity == 1.0);
    BOOST_TEST(s.periodic_x.value() == 40.0);
    BOOST_TEST(!s.periodic_y.has_value());
    BOOST_TEST((s.integrator == Integrator::verlet_half_step));
    BOOST_TEST(s.dt == 0.001);
    BOOST_TEST(s.steps == 2000);
    BOOST_TEST(s.frame_every == 100);
    BOOST_TEST(s.grains.diameter == 2.0);
    BOOST_TEST(s.grains.mass == 1.0);
    BOOST_TEST((s.contact.damping_acts_on == Damping::full_vector));
    BOOST_TEST((s.contact.clipping == Clipping::none));
    BOOST_TEST((s.contact.spins == Spins::off));
    BOOST_TEST((s.plates.touches == PlateContact::centre));
    BOOST_TEST_REQUIRE(s.plates.bottom.has_value());
    BOOST_TEST(s.plates.bottom->height == 0.0);
    BOOST_TEST(s.plates.bottom->amplitude == 0.5);
    BOOST_TEST(s.plates.bottom->period == 2.0);
    BOOST_TEST_REQUIRE(s.has_free_lid());
    const auto lid = std::get<FreeLid>(s.plates.lid);
    BOOST_TEST(lid.mass == 5.0);
    BOOST_TEST(lid.height == 20.0);
    BOOST_TEST(lid.velocity == -1.0);
    BOOST_TEST(s.initial.x == (std::vector{1.0, 4.0}), tt::per_element());
    BOOST_TEST(s.initial.y == (std::vector{5.0, 6.0}), tt::per_element());
    BOOST_TEST(s.initial.vx == (std::vector{0.5, 0.0}), tt::per_element());
    BOOST_TEST(s.initial.vy == (std::vector{0.0, 0.25}), tt::per_element());
    BOOST_TEST(!s.has_frozen_grains());
}

BOOST_AUTO_TEST_CASE(every_word_arrives_as_its_own_choice) {
    BOOST_TEST(
        (with("full-vector", "normal-only").contact.damping_acts_on == Damping::normal_only));
    BOOST_TEST((with("\"none\"", "\"all\"").contact.clipping == Clipping::all));
    BOOST_TEST((with("\"none\"", "\"normal-only\"").contact.clipping == Clipping::normal_only));
    BOOST_TEST((with("\"off\"", "\"on\"").contact.spins == Spins::on));
    BOOST_TEST((with("\"centre\"", "\"surface\"").plates.touches == PlateContact::surface));
    BOOST_TEST((with("half-step", "predicted").integrator == Integrator::verlet_predicted));
    const std::string key = "integrator = \"verlet-half-step\"";
    for (const auto integrator :
         {Integrator::leapfrog_crank_nicolson, Integrator::semi_implicit_euler,
          Integrator::explicit_euler, Integrator::runge_kutta_4, Integrator::taguchi_euler,
          Integrator::taguchi_adaptive_euler}) {
        const std::string word = to_string(integrator);
        BOOST_TEST((with(key, "integrator = \"" + word + '"').integrator == integrator), word);
    }
    BOOST_TEST((with(key, key + "\ncontacts = \"lattice-neighbours\"").contacts ==
                Contacts::lattice_neighbours));
    BOOST_TEST((with(key, key + "\nprecision = \"mixed\"").precision == Precision::mixed));
}

BOOST_AUTO_TEST_CASE(contacts_and_precision_are_the_usual_ones_if_nothing_is_said) {
    const auto s = tests::read_scene(scene_text);
    BOOST_TEST((s.contacts == Contacts::neighbour_list));
    BOOST_TEST((s.precision == Precision::double_precision));
    BOOST_TEST(s.plates.bottom->phase == 0.0);
}

BOOST_AUTO_TEST_CASE(a_plate_may_start_at_any_phase) {
    const auto s = with("period = 2.0", "period = 2.0, phase = 0.25");
    BOOST_TEST(s.plates.bottom->phase == 0.25);
    // A quarter period later than cos: at its mean height, moving down.
    BOOST_TEST(std::abs(height_at(*s.plates.bottom, 0)) < 1e-15);
    BOOST_TEST(height_at(*s.plates.bottom, 0.5) == -0.5, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(gamma_gives_the_amplitude_of_the_bottom) {
    // b = gamma g/omega^2, omega = pi.
    const auto s = tests::read_scene(replaced(replaced(scene_text, "amplitude = 0.5, ", ""),
                                              "gravity = 1.0", "gravity = 1.0\ngamma = 2.5"));
    BOOST_TEST(s.plates.bottom->amplitude == 2.5 / (3.14159265358979 * 3.14159265358979),
               tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(gamma_needs_an_amplitude_to_give) {
    const std::string with_gamma =
        replaced(scene_text, "gravity = 1.0", "gravity = 1.0\ngamma = 2");
    BOOST_CHECK_THROW((void)tests::read_scene(with_gamma), CaseError);
    const std::string still = replaced(scene_text, "amplitude = 0.5, period = 2.0 ", "");
    BOOST_CHECK_THROW(
        (void)tests::read_scene(replaced(replaced(still, "height = 0.0, ", "height = 0.0 "),
                                         "gravity = 1.0", "gravity = 1.0\ngamma = 2")),
        CaseError);
}

BOOST_AUTO_TEST_CASE(frames_at_every_so_many_steps) {
    const auto s = with("every_time = 0.1", "every_steps = 7");
    BOOST_TEST(s.frame_every == 7);
    BOOST_TEST(s.steps == 2002);  // the last frame is the end of the run
}

BOOST_AUTO_TEST_CASE(words_are_written_as_they_are_read) {
    const auto s = tests::read_scene(scene_text);
    BOOST_TEST(to_string(s.contact.damping_acts_on) == "full-vector");
    BOOST_TEST(to_string(s.contact.clipping) == "none");
    BOOST_TEST(to_string(s.contact.spins) == "off");
    BOOST_TEST(to_string(s.plates.touches) == "centre");
    BOOST_TEST(to_string(s.integrator) == "verlet-half-step");
    BOOST_TEST(to_string(Damping::normal_only) == "normal-only");
    BOOST_TEST(to_string(Clipping::all) == "all");
    BOOST_TEST(to_string(Clipping::normal_only) == "normal-only");
    BOOST_TEST(to_string(Spins::on) == "on");
    BOOST_TEST(to_string(PlateContact::surface) == "surface");
    BOOST_TEST(to_string(Integrator::verlet_predicted) == "verlet-predicted");
}

BOOST_AUTO_TEST_CASE(plates_take_the_contact_s_stiffness_unless_they_have_their_own) {
    const auto plain = tests::read_scene(scene_text);
    BOOST_TEST(plain.plates.stiffness == plain.contact.stiffness);
    BOOST_TEST(with("touch = \"centre\"", "touch = \"centre\"\nstiffness = 70").plates.stiffness ==
               70.0);
}

BOOST_AUTO_TEST_CASE(a_lid_without_mass_is_a_prescribed_plate) {
    const auto s = with("{ mass = 5.0, height = 20.0, velocity = -1.0 }",
                        "{ height = 20.0, amplitude = 0.25, period = 3.0 }");
    BOOST_TEST(!s.has_free_lid());
    const auto lid = std::get<PrescribedPlate>(s.plates.lid);
    BOOST_TEST(lid.height == 20.0);
    BOOST_TEST(lid.amplitude == 0.25);
    BOOST_TEST(lid.period == 3.0);
}

BOOST_AUTO_TEST_CASE(a_scene_without_plates_has_none) {
    const auto s = tests::read_scene(
        tests::with_initial("kind = \"explicit\"\nx = 0\ny = 0\nvx = 1\nvy = 0\n"));
    BOOST_TEST(!s.plates.bottom.has_value());
    BOOST_TEST(std::holds_alternative<std::monostate>(s.plates.lid));
    BOOST_TEST(s.grain_count() == 1u);
}

BOOST_AUTO_TEST_CASE(lengths_of_time_resolve_to_whole_steps_and_whole_frames) {
    // 20 contact times of 0.1 are 2000 steps; a frame every 0.5 contact times is every 50.
    auto s = tests::read_scene(replaced(replaced(scene_text, "time = 2.0", "contact_times = 20.0"),
                                        "every_time = 0.1", "every_contact_times = 0.5"));
    BOOST_TEST(s.steps == 2000);
    BOOST_TEST(s.frame_every == 50);
    // What does not divide: frames every 0.3 of 2 become seven whole intervals, the last frame is
    // the end of the run.
    s = with("every_time = 0.1", "every_time = 0.3");
    BOOST_TEST(s.frame_every == 300);
    BOOST_TEST(s.steps == 2100);
}

BOOST_AUTO_TEST_CASE(steps_are_rounded_to_the_nearest) {
    BOOST_TEST(with("every_time = 0.1", "every_time = 0.0014").frame_every == 1);
    BOOST_TEST(with("every_time = 0.1", "every_time = 0.0016").frame_every == 2);
    // 2.0/0.0003 = 6666.7 steps, 0.1/0.0003 = 333.3
    const auto s = with("dt = 0.001", "dt = 0.0003");
    BOOST_TEST(s.frame_every == 333);
    BOOST_TEST(s.steps == 333 * 21);  // 6667 steps end within the 21st interval
    BOOST_TEST(s.steps % s.frame_every == 0);
}

BOOST_AUTO_TEST_CASE(first_and_last_frames_only) {
    const auto s = with("every_time = 0.1", "first_and_last = true");
    BOOST_TEST(s.steps == 2000);
    BOOST_TEST(s.frame_every == 2000);
    BOOST_TEST(with("every_time = 0.1", "first_and_last = false, every_time = 0.1").frame_every ==
               100);
}

BOOST_AUTO_TEST_CASE(a_ladder_of_time_steps_is_read_rung_by_rung) {
    const auto text = replaced(scene_text, "dt = 0.001", "steps_per_contact_time = [10, 20.5, 40]");
    const toml::table root = toml::parse(text);
    BOOST_TEST(ladder_size(toml_input::TomlTable("case.toml", "scene", {&root})) == 3u);
    BOOST_TEST(tests::read_scene(text, 1, 0).dt == 0.01, tt::tolerance(1e-14));
    BOOST_TEST(tests::read_scene(text, 1, 1).dt == 0.1 / 20.5, tt::tolerance(1e-14));
    BOOST_TEST(tests::read_scene(text, 1, 2).dt == 0.0025, tt::tolerance(1e-14));
    const auto listed = replaced(scene_text, "dt = 0.001", "dt = [0.001, 0.002]");
    BOOST_TEST(tests::read_scene(listed, 1, 1).dt == 0.002);
}
