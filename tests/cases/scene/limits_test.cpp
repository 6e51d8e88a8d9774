// Sizes are computed and refused before anything is made: grains, frames, steps, lattices.
#include "cases/scene/collision_notation.hpp"
#include "cases/scene/limits.hpp"
#include "tests/cases/scene/gas_text.hpp"
#include "tests/cases/scene/scene_text.hpp"

#include <boost/test/unit_test.hpp>

#include <stdexcept>
#include <string>

using namespace crossgrain;
using tests::gas_text;
using tests::refusal;
using tests::refusal_with;
using tests::replaced;

namespace {

const std::string hopper_text = R"(outlet = 20
levels = 800
angles = [10.0, 40.0]
c_d = 0.01
c_o = 0.0
c_i = 0.1
c_w = 10.0
iterations = 100
every = 50
)";

scene::HopperAutomaton read_hopper(const std::string& text) {
    const toml::table root = toml::parse(text);
    return scene::read_hopper_automaton(toml_input::TomlTable("case.toml", "scene", {&root}),
                                        {.name = "test", .seed = 1});
}

CaseErrorDetails gas_refusal(const std::string& what, const std::string& by) {
    return refusal([&] { (void)tests::read_gas(replaced(gas_text, what, by)); });
}

CaseErrorDetails hopper_refusal(const std::string& what, const std::string& by) {
    return refusal([&] { (void)read_hopper(replaced(hopper_text, what, by)); });
}

/// Why a scene with this initial state, and `periods` along x and y, is refused.
std::string initial_refusal(const std::string& initial, const std::string& periods = "") {
    std::string text = replaced(tests::with_initial(initial), "periodic_x = 40.0\n", periods);
    const auto e = refusal([&] { (void)tests::read_scene(text); });
    BOOST_TEST(e.key == "scene.initial");
    return e.got;
}

void check_too_many(const std::string& answer) {
    BOOST_TEST(answer.find("more than 10000000") != std::string::npos, answer);
}

}  // namespace

BOOST_AUTO_TEST_CASE(grains_of_a_pipe_are_counted_first) {
    const std::string pipe = "kind = \"pipe\"\nwidth = 100.0\nvelocity_spread = 1.0\n";
    const std::string period = "periodic_y = 1e3\n";
    check_too_many(initial_refusal(pipe + "wall_spacing = 1e-9\narea_fraction = 0.1\n", period));
    check_too_many(
        initial_refusal(pipe + "wall_spacing = 2.0\narea_fraction = 0.1\n", "periodic_y = 3e7\n"));
    BOOST_TEST(initial_refusal(pipe + "wall_spacing = 2.0\narea_fraction = 1e-9\n", period) ==
               "the area fraction leaves no grain");
    BOOST_CHECK_NO_THROW((void)tests::read_scene(
        replaced(tests::with_initial(pipe + "wall_spacing = 2.0\narea_fraction = 0.1\n"),
                 "periodic_x = 40.0\n", period)));
}

BOOST_AUTO_TEST_CASE(grains_of_a_hopper_are_counted_first) {
    const auto hopper = [](const char* angle, const char* outlet, const char* height) {
        return std::string("kind = \"hopper\"\nangle = ") + angle + "\noutlet = " + outlet +
               "\nheight = " + height + "\n";
    };
    check_too_many(initial_refusal(hopper("30.0", "10.0", "1e9")));
    check_too_many(initial_refusal(hopper("30.0", "1e9", "10.0")));
    check_too_many(initial_refusal(hopper("179.9999999999", "10.0", "10.0")));
    check_too_many(initial_refusal(hopper("30.0", "1e307", "1e307")));
    // Few grains, but a plug without end.
    check_too_many(initial_refusal(hopper("0.0", "1e9", "10.0") + "settled_fraction = 1e-9\n"));
    const std::string settled = replaced(hopper("30.0", "10.0", "20.0"), "hopper", "settled");
    BOOST_TEST(initial_refusal(settled + "settle_time = 1e300\n").find("steps") !=
               std::string::npos);
    BOOST_CHECK_NO_THROW((void)tests::read_scene(
        replaced(tests::with_initial(hopper("30.0", "10.0", "20.0")), "periodic_x = 40.0\n", "")));
}

BOOST_AUTO_TEST_CASE(rows_of_a_packing_are_counted_first) {
    const std::string text =
        replaced(replaced(tests::scene_text.substr(0, tests::scene_text.find("[initial]")),
                          "periodic_x = 40.0", "periodic_x = 3e7"),
                 "lid = {", "#") +
        "[initial]\nkind = \"packing\"\ncount = 10\nvelocity_spread = 0.0\n";
    check_too_many(refusal([&] { (void)tests::read_scene(text); }).got);
}

BOOST_AUTO_TEST_CASE(grains_stay_near_the_origin_and_finite) {
    const auto apart = [](const char* x) {
        return std::string("kind = \"explicit\"\nx = [0.0, ") + x +
               "]\ny = [0.0, 0.0]\nvx = [0.0, 0.0]\nvy = [0.0, 0.0]\n";
    };
    BOOST_TEST(initial_refusal(apart("1e9")).find("farther than 1e+07") != std::string::npos);
    BOOST_TEST(initial_refusal(apart("-1e300")).find("farther than") != std::string::npos);
    BOOST_CHECK_NO_THROW((void)tests::read_scene(
        replaced(tests::with_initial(apart("1e7")), "periodic_x = 40.0\n", "")));
    BOOST_TEST(initial_refusal("kind = \"gas\"\ncount = 9\nvelocity_spread = 1e308\n",
                               "periodic_x = 40.0\nperiodic_y = 40.0\n")
                   .find("not finite") != std::string::npos);
    // The grid of pairs is as wide as their flight.
    BOOST_TEST(initial_refusal("kind = \"pairs\"\ncount = 9\napproach_speed = 1e300\n")
                   .find("farther than") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(periods_are_no_longer_than_grains_may_be_apart) {
    const auto e = refusal_with("periodic_x = 40.0", "periodic_x = 1e300");
    BOOST_TEST(e.key == "scene.periodic_x");
    BOOST_TEST(e.problem == "is too long");
    BOOST_TEST(refusal_with("periodic_x = 40.0", "periodic_y = 1e12").key == "scene.periodic_y");
    BOOST_CHECK_NO_THROW((void)tests::read_scene(
        replaced(tests::scene_text, "periodic_x = 40.0", "periodic_x = 4e7")));
}

BOOST_AUTO_TEST_CASE(frames_of_grains_are_bounded) {
    const auto e = refusal_with("time = 2.0\nframes = { every_time = 0.1 }",
                                "time = 1e5\nframes = { every_steps = 1 }");
    BOOST_TEST(e.key == "scene.frames");
    BOOST_TEST(e.problem == "makes too many frames");
    BOOST_TEST(e.got == "100000001");
    BOOST_TEST(refusal_with("time = 2.0", "time = 1e300").problem == "is too long");
    BOOST_CHECK_NO_THROW((void)tests::read_scene(
        replaced(tests::scene_text, "time = 2.0\nframes = { every_time = 0.1 }",
                 "time = 1e5\nframes = { first_and_last = true }")));
}

BOOST_AUTO_TEST_CASE(a_pipe_of_gas_fits_into_memory) {
    const auto e = gas_refusal("length = 220\nwidth = 11", "length = 10000000\nwidth = 100");
    BOOST_TEST(e.key == "scene.length");
    BOOST_TEST(e.problem == "makes too large a pipe");
    BOOST_TEST(e.expected.starts_with("at most "));
    BOOST_TEST(gas_refusal("length = 220\nwidth = 11",
                           "length = 10000000\nwidth = 100\nengine = \"table\"")
                   .key == "scene.length");
}

BOOST_AUTO_TEST_CASE(a_pipe_of_gas_holds_a_particle) {
    const auto e = gas_refusal("density = 1.0", "density = 1e-4");
    BOOST_TEST(e.key == "scene.density");
    BOOST_TEST(e.problem == "makes an empty pipe");
    BOOST_TEST(e.got == "0.0001, which is 0.242 particles in 220 x 11 sites");
    BOOST_CHECK_NO_THROW(
        (void)tests::read_gas(replaced(gas_text, "density = 1.0", "density = 5e-4")));
}

BOOST_AUTO_TEST_CASE(frames_of_a_gas_are_bounded) {
    const auto e = gas_refusal("steps = 1000, every = 10", "steps = 1000000000000, every = 1");
    BOOST_TEST(e.key == "scene.sample.every");
    BOOST_TEST(e.problem == "makes too many frames");
}

BOOST_AUTO_TEST_CASE(runs_of_a_hopper_are_bounded) {
    BOOST_TEST(hopper_refusal("levels = 800", "levels = 1000000").key == "scene.levels");
    const auto e = hopper_refusal("angles = [10.0, 40.0]",
                                  "angles = { from = 1, to = 99, step = 0.001 }\nreplicas = 1000");
    BOOST_TEST(e.key == "scene.replicas");
    BOOST_TEST(hopper_refusal("iterations = 100\nevery = 50", "iterations = 1000000000\nevery = 1")
                   .problem == "makes too many frames");
    BOOST_CHECK_NO_THROW((void)read_hopper(hopper_text));
}

BOOST_AUTO_TEST_CASE(probabilities_are_not_nested_without_end) {
    const auto nested = [](std::size_t depth) {
        return std::string(depth, '(') + "p" + std::string(depth, ')');
    };
    BOOST_TEST(scene::parse_probability(nested(32)).p_factor == 1.0);
    for (const std::size_t depth : {std::size_t{33}, std::size_t{200'000}}) {
        BOOST_CHECK_THROW((void)scene::parse_probability(nested(depth)), std::invalid_argument);
    }
    // Beside each other they are not nested.
    std::string sum = "(0)";
    for (int i = 0; i < 100; ++i)
        sum += "+(0)";
    BOOST_TEST(scene::parse_probability(sum).constant == 0.0);
}
