// The keys of friction, of grains that differ, of drag and backing: what each means, and every
// contradiction refused at its place.
#include "tests/cases/scene/scene_text.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>

namespace tt = boost::test_tools;
using namespace crossgrain;
using tests::check_refusal;
using tests::replaced;

namespace {

const std::string spring = R"(force = "spring"
coefficient = 0.5
stiffness_ratio = 0.25
inertia_factor = 0.4
conventions = "liggghts"
)";

/// Line 1 is gravity; the friction table begins in line 13.
std::string frictional(const std::string& friction, const std::string& top = "") {
    return top + R"(gravity = 1.0
integrator = "verlet-half-step"
dt = 0.001
time = 2.0
frames = { every_time = 0.1 }
grains = { diameter = 2.0, mass = 1.0 }
[contact]
stiffness = 400.0
damping_coefficient = 3.0
damping = "normal-only"
clipping = "normal-only"
spins = "on"
[contact.friction]
)" + friction +
           R"([initial]
kind = "explicit"
x = [1.0, 4.0]
y = [5.0, 6.0]
vx = [0.5, 0.0]
vy = [0.0, 0.25]
)";
}

CaseErrorDetails refusal_of(const std::string& text) {
    return tests::refusal([&] { (void)tests::read_scene(text); });
}

CaseErrorDetails refusal_with(const std::string& what, const std::string& by) {
    return refusal_of(replaced(frictional(spring), what, by));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_spring_is_given_by_stiffness_or_by_its_ratio) {
    const auto s = tests::read_scene(frictional(spring));
    BOOST_TEST_REQUIRE(s.has_friction());
    const auto& friction = *s.contact.friction;
    BOOST_TEST((friction.force == scene::TangentialForce::spring));
    BOOST_TEST(friction.stiffness == 100.0);
    BOOST_TEST(friction.damping == 0.0);
    BOOST_TEST(friction.coefficient == 0.5);
    BOOST_TEST(friction.inertia_factor == 0.4);
    BOOST_TEST((friction.conventions == scene::conventions_named("liggghts")));
    const auto plain = replaced(frictional(spring), "stiffness_ratio = 0.25", "stiffness = 70");
    BOOST_TEST(tests::read_scene(plain).contact.friction->stiffness == 70.0);
    check_refusal(refusal_with("stiffness_ratio = 0.25", "stiffness_ratio = 0.25\nstiffness = 7"),
                  "contact.friction.stiffness_ratio", 16, "contradicts");
    check_refusal(refusal_with("stiffness_ratio = 0.25", ""), "contact.friction.stiffness", 13,
                  "is missing");
}

BOOST_AUTO_TEST_CASE(a_dashpot_has_no_stiffness_and_needs_damping) {
    const std::string dashpot = replaced(spring, "\"spring\"", "\"dashpot\"");
    check_refusal(refusal_of(frictional(dashpot)), "contact.friction.stiffness_ratio", 16,
                  "contradicts");
    const std::string without = replaced(dashpot, "stiffness_ratio = 0.25\n", "");
    check_refusal(refusal_of(frictional(without)), "contact.friction.damping", 13, "is missing");
    const auto s = tests::read_scene(frictional(without + "damping = 20.0\n"));
    BOOST_TEST(s.contact.friction->damping == 20.0);
    BOOST_TEST(s.contact.friction->stiffness == 0.0);
}

BOOST_AUTO_TEST_CASE(conventions_are_a_code_s_a_table_or_each_code_s_own) {
    const auto with = [](const std::string& value) {
        return replaced(frictional(spring), "\"liggghts\"", value);
    };
    BOOST_TEST(!tests::read_scene(with("\"own\"")).contact.friction->conventions.has_value());
    const auto table = tests::read_scene(
        with("{ velocity_lever = \"radius\", torque_lever = \"contact-point\", rotation = "
             "\"rotate\", limit = \"total\" }"));
    const scene::FrictionConventions expected{.velocity_lever = scene::Lever::radius,
                                              .torque_lever = scene::Lever::contact_point,
                                              .rotation = scene::SpringRotation::rotate,
                                              .limit = scene::CoulombLimit::total};
    BOOST_TEST((table.contact.friction->conventions == expected));
    const auto e = refusal_with("\"liggghts\"", "\"ligghts\"");
    check_refusal(e, "contact.friction.conventions", 18, "is not known");
    BOOST_TEST(e.hint == "did you mean \"liggghts\"?");
    check_refusal(refusal_of(with("{ velocity_lever = \"radius\" }")),
                  "contact.friction.conventions.torque_lever", 18, "is missing");
}

BOOST_AUTO_TEST_CASE(friction_needs_spins_and_normal_damping) {
    check_refusal(refusal_with("spins = \"on\"", "spins = \"off\""), "contact.spins", 12,
                  "contradicts");
    check_refusal(refusal_with("damping = \"normal-only\"", "damping = \"full-vector\""),
                  "contact.damping", 10, "contradicts");
}

BOOST_AUTO_TEST_CASE(friction_out_of_range_or_unknown_is_refused) {
    check_refusal(refusal_with("coefficient = 0.5", "coefficient = -0.5"),
                  "contact.friction.coefficient", 15, "is out of range");
    check_refusal(refusal_with("inertia_factor = 0.4", "inertia_factor = 0"),
                  "contact.friction.inertia_factor", 17, "is out of range");
    check_refusal(refusal_with("inertia_factor = 0.4", "inertia_factor = 0.4\nmu = 1"),
                  "contact.friction.mu", 18, "is not a known key");
}

BOOST_AUTO_TEST_CASE(damping_per_effective_mass_gives_the_same_restitution) {
    const auto text =
        replaced(frictional(spring), "stiffness = 400.0\ndamping_coefficient = 3.0",
                 "restitution = 0.8\ncontact_time = 0.1\ndamping_scale = \"effective-mass\"");
    const auto heavy = replaced(text, "mass = 1.0", "mass = 3.0");
    for (const auto& s : {tests::read_scene(text), tests::read_scene(heavy)}) {
        // Per unit of m/2: twice -ln(e)/t_col, whatever the mass.
        BOOST_TEST(s.contact.damping == 2 * 2.2314355131420975, tt::tolerance(1e-15));
        BOOST_TEST(contact_time(s) == 0.1, tt::tolerance(1e-14));
    }
}

BOOST_AUTO_TEST_CASE(drag_and_backing_are_read_and_checked) {
    const std::string backing = "drag = 0.05\nbacking = { left = 0.0, right = 11.0 }\n";
    const auto s = tests::read_scene(frictional(spring, backing));
    BOOST_TEST(s.drag == 0.05);
    BOOST_TEST_REQUIRE(s.backing.has_value());
    BOOST_TEST(s.backing->stiffness == 400.0);  // the contact's
    BOOST_TEST(s.backing->right == 11.0);
    const auto swapped = replaced(frictional(spring, backing), "right = 11.0", "right = -1.0");
    check_refusal(refusal_of(swapped), "backing.right", 2, "is out of range");
    check_refusal(refusal_of(frictional(spring, backing + "periodic_x = 9.0\n")), "backing", 2,
                  "contradicts");
    check_refusal(refusal_of(frictional(spring, "drag = -1.0\n")), "drag", 1, "is out of range");
}

BOOST_AUTO_TEST_CASE(explicit_grains_may_spin_and_differ) {
    const std::string text =
        frictional(spring) + "omega = [1.0, -2.0]\ndiameters = [2.0, 1.0]\nmasses = [1.0, 0.1]\n";
    const auto s = tests::read_scene(text);
    BOOST_TEST(s.initial.omega == (std::vector<double>{1, -2}), tt::per_element());
    BOOST_TEST(s.grains.diameter_of(1) == 1.0);
    BOOST_TEST(s.grains.mass_of(1) == 0.1);
    check_refusal(refusal_of(replaced(text, "[2.0, 1.0]", "[2.0]")), "initial.diameters", 26,
                  "has the wrong length");
    check_refusal(refusal_of(replaced(text, "masses = [1.0, 0.1]\n", "")), "initial.masses", 19,
                  "is missing");
    // Without friction nothing feels a spin.
    const auto e = tests::refusal(
        [] { (void)tests::read_scene(tests::scene_text + "omega = [1.0, -2.0]\n"); });
    BOOST_TEST(e.key == "scene.initial");
}
