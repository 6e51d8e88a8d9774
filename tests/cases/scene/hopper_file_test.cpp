// A hopper's table says all that a run needs, named readings change one rule each, and what cannot
// run is refused at its place.
#include "cases/scene/model_file.hpp"
#include "tests/cases/scene/scene_text.hpp"

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::scene;
using tests::check_refusal;
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

HopperAutomaton read(const std::string& text, std::uint64_t seed = 1) {
    const toml::table root = toml::parse(text);
    return read_hopper_automaton(toml_input::TomlTable("case.toml", "scene", {&root}),
                                 {.name = "test", .seed = seed});
}

CaseErrorDetails refusal_with(const std::string& what, const std::string& by) {
    return tests::refusal([&] { (void)read(replaced(hopper_text, what, by)); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_key_of_the_file_arrives_in_the_scene) {
    const auto s = read(hopper_text + "replicas = 3\nflipped = 4\nrandom = \"shared-stream\"\n"
                                      "engine = \"plain\"\n",
                        42);
    BOOST_TEST(s.name == "test");
    BOOST_TEST(s.seed == 42u);
    BOOST_TEST(s.outlet == 20);
    BOOST_TEST(s.levels == 800);
    BOOST_TEST(s.angles == (std::vector{10.0, 40.0}), tt::per_element());
    BOOST_TEST(s.c_d == 0.01);
    BOOST_TEST(s.c_o == 0.0);
    BOOST_TEST(s.c_i == 0.1);
    BOOST_TEST(s.c_w == 10.0);
    BOOST_TEST(s.iterations == 100);
    BOOST_TEST(s.every == 50);
    BOOST_TEST(s.replicas == 3);
    BOOST_TEST(s.flipped == 4);
    BOOST_TEST((s.random == HopperRandom::shared_stream));
    BOOST_TEST((s.engine == HopperEngine::plain));
    BOOST_TEST(s.reading.name == "standard");
    BOOST_TEST((s.reading.sweep == HopperSweep::bottom_to_top));
    BOOST_TEST((s.reading.rows == HopperRows::half_levels));
    BOOST_TEST((s.reading.inertia == HopperInertia::source_orientation));
    BOOST_TEST(s.reading.rotation);
    BOOST_TEST(s.reading.tie_tolerance == 1e-3);
}

BOOST_AUTO_TEST_CASE(what_is_left_out_is_one_replica_without_a_twin_seen_first_and_last) {
    const auto s = read(replaced(hopper_text, "every = 50\n", ""));
    BOOST_TEST(s.every == 100);
    BOOST_TEST(s.replicas == 1);
    BOOST_TEST(s.flipped == 0);
    BOOST_TEST((s.random == HopperRandom::per_site));
    BOOST_TEST((s.engine == HopperEngine::fast));
}

BOOST_AUTO_TEST_CASE(angles_are_a_list_a_number_a_sweep_or_the_slope_of_the_walls) {
    const auto angles = [](const std::string& by) {
        return read(replaced(hopper_text, "angles = [10.0, 40.0]", by)).angles;
    };
    BOOST_TEST(angles("angles = 36.87") == (std::vector{36.87}), tt::per_element());
    const auto sweep = angles("angles = { from = 10, to = 90, step = 0.1 }");
    BOOST_TEST_REQUIRE(sweep.size() == 801u);  // Gremaud, Fig. 7
    BOOST_TEST(sweep.front() == 10.0);
    BOOST_TEST(sweep[1] == 10.1, tt::tolerance(1e-14));
    BOOST_TEST(sweep.back() == 90.0, tt::tolerance(1e-14));
    BOOST_TEST(angles("angles = { from = 10, to = 14, step = 3 }") == (std::vector{10.0, 13.0}),
               tt::per_element());
    // tan(theta/2) = 1/3 is 36.87 degrees (Gremaud, Experiment 1).
    BOOST_TEST(angles("slope = 3").front() == 36.86989764584402, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(each_named_reading_changes_one_rule) {
    const auto named = [](const std::string& name) {
        const auto s = read(hopper_text + "reading = \"" + name + "\"\n");
        BOOST_TEST(s.reading.name == name);
        return s.reading;
    };
    BOOST_TEST((named("standard").rows == HopperRows::half_levels));
    BOOST_TEST((named("zigzag").rows == HopperRows::zigzag));
    BOOST_TEST((named("top-to-bottom").sweep == HopperSweep::top_to_bottom));
    BOOST_TEST((named("literal-inertia").inertia == HopperInertia::literal));
    BOOST_TEST(!named("no-rotation").rotation);
    BOOST_TEST(named("strict-ties").tie_tolerance == 1e-9);
}

BOOST_AUTO_TEST_CASE(single_rules_are_changed_by_their_keys) {
    const auto r = read(hopper_text + "sweep = \"top-to-bottom\"\nrows = \"zigzag\"\n"
                                      "inertia = \"literal\"\nrotation = false\n"
                                      "tie_tolerance = 0\n")
                       .reading;
    BOOST_TEST(r.name == "standard, changed");
    BOOST_TEST((r.sweep == HopperSweep::top_to_bottom));
    BOOST_TEST((r.rows == HopperRows::zigzag));
    BOOST_TEST((r.inertia == HopperInertia::literal));
    BOOST_TEST(!r.rotation);
    BOOST_TEST(r.tie_tolerance == 0.0);
}

BOOST_AUTO_TEST_CASE(words_are_written_as_they_are_read) {
    BOOST_TEST(to_string(HopperSweep::bottom_to_top) == "bottom-to-top");
    BOOST_TEST(to_string(HopperSweep::top_to_bottom) == "top-to-bottom");
    BOOST_TEST(to_string(HopperRows::half_levels) == "half-levels");
    BOOST_TEST(to_string(HopperRows::zigzag) == "zigzag");
    BOOST_TEST(to_string(HopperInertia::source_orientation) == "source-orientation");
    BOOST_TEST(to_string(HopperInertia::literal) == "literal");
    BOOST_TEST(to_string(HopperRandom::per_site) == "per-site");
    BOOST_TEST(to_string(HopperRandom::shared_stream) == "shared-stream");
    BOOST_TEST(to_string(HopperEngine::fast) == "fast");
    BOOST_TEST(to_string(HopperEngine::plain) == "plain");
}

BOOST_AUTO_TEST_CASE(a_number_out_of_range_is_refused_with_its_key_and_line) {
    const auto check = [](const std::string& what, const std::string& by, const std::string& key,
                          int line) {
        check_refusal(refusal_with(what, by), key, line, "is out of range");
    };
    check("outlet = 20", "outlet = 1", "outlet", 1);  // level 1 would have no site
    check("levels = 800", "levels = 0", "levels", 2);
    check("[10.0, 40.0]", "[10.0, 0.0]", "angles", 3);
    check("[10.0, 40.0]", "180.0", "angles", 3);
    check("[10.0, 40.0]", "-20", "angles", 3);
    check("angles = [10.0, 40.0]", "slope = 0", "slope", 3);
    check("[10.0, 40.0]", "{ from = 0, to = 20, step = 1 }", "angles.from", 3);
    check("[10.0, 40.0]", "{ from = 10, to = 180, step = 1 }", "angles.to", 3);
    check("[10.0, 40.0]", "{ from = 10, to = 20, step = 0 }", "angles.step", 3);
    check("c_d = 0.01", "c_d = -0.01", "c_d", 4);
    check("c_o = 0.0", "c_o = -1", "c_o", 5);
    check("c_i = 0.1", "c_i = -0.1", "c_i", 6);
    check("c_w = 10.0", "c_w = -10", "c_w", 7);
    check("iterations = 100", "iterations = 0", "iterations", 8);
    check("every = 50", "every = 0", "every", 9);
    check("every = 50", "every = 50\nreplicas = 0", "replicas", 10);
    check("every = 50", "every = 50\nflipped = -1", "flipped", 10);
    check("every = 50", "every = 50\ntie_tolerance = -1", "tie_tolerance", 10);
}

BOOST_AUTO_TEST_CASE(contradictions_and_unknown_words_are_refused) {
    check_refusal(refusal_with("c_d = 0.01", "slope = 3\nc_d = 0.01"), "slope", 4, "contradicts");
    check_refusal(refusal_with("every = 50", "every = 101"), "every", 9, "is longer than the run");
    check_refusal(refusal_with("[10.0, 40.0]", "{ from = 20, to = 10, step = 1 }"), "angles.to", 3,
                  "is below 'from'");
    check_refusal(refusal_with("[10.0, 40.0]", "{ from = 10, to = 90, step = 1e-9 }"),
                  "angles.step", 3, "is too small");
    check_refusal(refusal_with("[10.0, 40.0]", "179.99"), "levels", 2, "makes too large a hopper");
    check_refusal(refusal_with("every = 50", "every = 50\nnozzle = 3"), "nozzle", 10,
                  "is not a known key");
    const auto e = refusal_with("every = 50", "every = 50\nreading = \"zigzags\"");
    check_refusal(e, "reading", 10, "is not known");
    BOOST_TEST(e.hint == "did you mean \"zigzag\"?");
    BOOST_TEST(refusal_with("angles = [10.0, 40.0]", "").problem == "is missing");
    BOOST_TEST(refusal_with("c_w = 10.0", "").key == "scene.c_w");
}

BOOST_AUTO_TEST_CASE(a_tie_tolerance_that_makes_all_candidates_equal_is_refused) {
    // Energies differ by at most 4 C_D + C_W (at a wall) + 2 C_I = 10.24.
    check_refusal(refusal_with("every = 50", "every = 50\ntie_tolerance = 10.25"), "tie_tolerance",
                  10, "makes all candidates equal");
    BOOST_TEST(read(hopper_text + "tie_tolerance = 10.23\n").reading.tie_tolerance == 10.23);
    // No energy at all is the model's null case, not the tolerance's fault.
    const std::string null_case =
        replaced(replaced(replaced(hopper_text, "c_d = 0.01", "c_d = 0"), "c_i = 0.1", "c_i = 0"),
                 "c_w = 10.0", "c_w = 0");
    BOOST_TEST(read(null_case).c_d == 0.0);
}
