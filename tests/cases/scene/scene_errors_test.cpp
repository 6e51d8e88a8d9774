// Every way to get a scene file wrong, outside its contact law and initial state, is refused at its
// place: nothing slips, nothing is guessed.
#include "tests/cases/scene/scene_text.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using tests::check_refusal;
using tests::refusal_with;

BOOST_AUTO_TEST_CASE(an_unknown_key_of_any_table_is_refused_with_the_nearest_one) {
    const auto check = [](const std::string& what, const std::string& by, const std::string& key,
                          int line, const std::string& hint) {
        const auto e = refusal_with(what, by);
        check_refusal(e, key, line, "is not a known key");
        BOOST_TEST(e.hint == hint);
    };
    check("periodic_x = 40.0", "periodic_z = 40.0", "periodic_z", 2, "did you mean 'periodic_x'?");
    check("mass = 1.0 }", "mass = 1.0, radius = 1 }", "grains.radius", 7, "");
    check("spins = \"off\"", "spins = \"off\"\nrestituton = 0.7", "contact.restituton", 14,
          "did you mean 'restitution'?");
    check("touch = \"centre\"", "touch = \"centre\"\nstifness = 1", "plates.stifness", 16,
          "did you mean 'stiffness'?");
    check("period = 2.0", "period = 2.0, frequency = 3", "plates.bottom.frequency", 16, "");
    check("mass = 5.0,", "mass = 5.0, period = 1.0,", "plates.lid.period", 17, "");
    check("every_time = 0.1", "every_time = 0.1, evry = 2", "frames.evry", 6, "");
    check("kind = \"explicit\"", "kind = \"explicit\"\nvz = [0.0, 0.0]", "initial.vz", 20,
          "did you mean 'vx'?");
}

BOOST_AUTO_TEST_CASE(a_missing_key_is_refused) {
    const auto check = [](const std::string& what, const std::string& key) {
        const auto e = refusal_with(what, "");
        BOOST_TEST(e.key == "scene." + key);
        BOOST_TEST(e.problem == "is missing");
    };
    check("gravity = 1.0", "gravity");
    check("integrator = \"verlet-half-step\"", "integrator");
    check("dt = 0.001", "dt");
    check("time = 2.0", "time");
    check("every_time = 0.1", "frames.every_time");
    check("frames = { every_time = 0.1 }", "frames.every_time");
    check("diameter = 2.0, ", "grains.diameter");
    check(", mass = 1.0", "grains.mass");
    check("grains = { diameter = 2.0, mass = 1.0 }", "grains.diameter");
    check("touch = \"centre\"", "plates.touch");
    check("height = 0.0, ", "plates.bottom.height");
    check("kind = \"explicit\"", "initial.kind");
}

BOOST_AUTO_TEST_CASE(a_number_out_of_range_is_refused) {
    const auto check = [](const std::string& what, const std::string& by, const std::string& key,
                          int line) {
        check_refusal(refusal_with(what, by), key, line, "is out of range");
    };
    check("gravity = 1.0", "gravity = -1.0", "gravity", 1);
    check("periodic_x = 40.0", "periodic_x = 0", "periodic_x", 2);
    check("periodic_x = 40.0", "periodic_y = -40", "periodic_y", 2);
    check("dt = 0.001", "dt = 0", "dt", 4);
    check("dt = 0.001", "dt = [0.001, -0.001]", "dt", 4);
    check("dt = 0.001", "steps_per_contact_time = -10", "steps_per_contact_time", 4);
    check("time = 2.0", "time = -2.0", "time", 5);
    check("time = 2.0", "contact_times = 0", "contact_times", 5);
    check("every_time = 0.1", "every_time = -1", "frames.every_time", 6);
    check("diameter = 2.0", "diameter = -2.0", "grains.diameter", 7);
    check("mass = 1.0 }", "mass = 0 }", "grains.mass", 7);
    check("touch = \"centre\"", "touch = \"centre\"\nstiffness = -1", "plates.stiffness", 16);
    check("amplitude = 0.5", "amplitude = -0.5", "plates.bottom.amplitude", 16);
    check("period = 2.0", "period = 0", "plates.bottom.period", 16);
    check("mass = 5.0", "mass = -5.0", "plates.lid.mass", 17);
}

BOOST_AUTO_TEST_CASE(a_wrong_type_is_refused) {
    const auto check = [](const std::string& what, const std::string& by, const std::string& key,
                          int line) {
        check_refusal(refusal_with(what, by), key, line, "has the wrong type");
    };
    check("gravity = 1.0", "gravity = \"1.0\"", "gravity", 1);
    check("\"verlet-half-step\"", "1", "integrator", 3);
    check("{ diameter = 2.0, mass = 1.0 }", "2.0", "grains", 7);
    check("{ every_time = 0.1 }", "0.1", "frames", 6);
    check("{ height = 0.0, amplitude = 0.5, period = 2.0 }", "0.0", "plates.bottom", 16);
    check("every_time = 0.1", "first_and_last = 1", "frames.first_and_last", 6);
}

BOOST_AUTO_TEST_CASE(two_time_steps_or_two_durations_are_a_contradiction) {
    check_refusal(refusal_with("dt = 0.001", "dt = 0.001\nsteps_per_contact_time = 100"),
                  "steps_per_contact_time", 5, "contradicts");
    check_refusal(refusal_with("time = 2.0", "time = 2.0\ncontact_times = 20"), "contact_times", 6,
                  "contradicts");
}

BOOST_AUTO_TEST_CASE(overlapping_frame_schedules_are_a_contradiction) {
    const auto e = refusal_with("every_time = 0.1", "every_time = 0.1, every_contact_times = 1");
    check_refusal(e, "frames.every_contact_times", 6, "contradicts");
    BOOST_TEST(e.got.find("scene.frames.every_time") != std::string::npos);
    // With first_and_last the interval is refused as well, at its place.
    const auto both = refusal_with("every_time = 0.1", "every_time = 0.1, first_and_last = true");
    BOOST_TEST(both.key == "scene.frames.every_time");
    BOOST_TEST(both.line == 6);
}

BOOST_AUTO_TEST_CASE(a_frame_interval_longer_than_the_run_is_refused) {
    check_refusal(refusal_with("every_time = 0.1", "every_time = 2.5"), "frames.every_time", 6,
                  "is longer than the run");
    // The error names the key that the user wrote, where he wrote it.
    const auto e = refusal_with("every_time = 0.1", "every_contact_times = 30.0");
    check_refusal(e, "frames.every_contact_times", 6, "is longer than the run");
}

BOOST_AUTO_TEST_CASE(frames_or_runs_shorter_than_a_time_step_are_refused) {
    check_refusal(refusal_with("every_time = 0.1", "every_time = 0.0004"), "frames.every_time", 6,
                  "is shorter than a time step");
    check_refusal(refusal_with("time = 2.0", "time = 0.0004"), "time", 5,
                  "is shorter than a time step");
    check_refusal(refusal_with("time = 2.0", "contact_times = 0.004"), "contact_times", 5,
                  "is shorter than a time step");
}

BOOST_AUTO_TEST_CASE(a_run_of_too_many_steps_is_refused) {
    check_refusal(refusal_with("time = 2.0", "time = 1e300"), "time", 5, "is too long");
    check_refusal(refusal_with("dt = 0.001", "dt = 1e-300"), "time", 5, "is too long");
}

BOOST_AUTO_TEST_CASE(a_period_along_y_excludes_plates) {
    const auto e = refusal_with("periodic_x = 40.0", "periodic_y = 40.0");
    check_refusal(e, "periodic_y", 2, "contradicts");
    BOOST_TEST(e.got == "plates as well");
    // A lid alone is a plate.
    const auto text =
        tests::replaced(tests::replaced(tests::scene_text, "periodic_x", "periodic_y"),
                        "bottom = { height = 0.0, amplitude = 0.5, period = 2.0 }", "");
    check_refusal(tests::refusal([&] { (void)tests::read_scene(text); }), "periodic_y", 2,
                  "contradicts");
}

BOOST_AUTO_TEST_CASE(an_amplitude_needs_a_period) {
    check_refusal(refusal_with(", period = 2.0", ""), "plates.bottom.period", 16, "is missing");
    BOOST_CHECK_NO_THROW((void)tests::read_scene(
        tests::replaced(tests::scene_text, ", amplitude = 0.5, period = 2.0", "")));
}

BOOST_AUTO_TEST_CASE(an_unknown_word_is_refused_with_the_choice) {
    const auto e = refusal_with("\"centre\"", "\"center\"");
    check_refusal(e, "plates.touch", 15, "is not known");
    BOOST_TEST(e.hint == "did you mean \"centre\"?");
    check_refusal(refusal_with("verlet-half-step", "leap-frog"), "integrator", 3, "is not known");
}
