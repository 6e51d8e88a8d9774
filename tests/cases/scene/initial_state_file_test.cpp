// Every way to get the [initial] table wrong is refused at its place, and no state that cannot be
// (overlaps, positions that are no numbers) becomes a scene.
#include "tests/cases/scene/scene_text.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace crossgrain;
using tests::check_refusal;
using tests::read_scene;
using tests::refusal_with;
using tests::replaced;
using tests::scene_text;
using tests::with_initial;

namespace {

const std::string pairs = "kind = \"pairs\"\ncount = 4\napproach_speed = 1.0\n";
const std::string gas = "kind = \"gas\"\ncount = 64\nvelocity_spread = 3.0\n";
const std::string box = "periodic_y = 40.0\n";
const std::string lattice = "kind = \"lattice\"\ncount = 40\ncolumns = 18\nvelocity_spread = 0.1\n";
const std::string bounces = "kind = \"bounces\"\ncount = 4\nspeed = 1.0\n";

CaseErrorDetails refusal_of(const std::string& text) {
    return tests::refusal([&] { (void)read_scene(text); });
}

/// The scene with its plates and another [initial] table.
std::string between_plates(const std::string& initial) {
    return scene_text.substr(0, scene_text.find("[initial]")) + "[initial]\n" + initial;
}

}  // namespace

BOOST_AUTO_TEST_CASE(all_kinds_are_read) {
    BOOST_TEST(read_scene(with_initial(pairs)).grain_count() == 8u);
    BOOST_TEST(read_scene(with_initial(gas, box)).grain_count() == 64u);
    BOOST_TEST(read_scene(between_plates(lattice)).grain_count() == 40u);
    BOOST_TEST(read_scene(between_plates(bounces)).grain_count() == 4u);
    const auto s = read_scene(with_initial(pairs + "frozen_partner = true\n"));
    const std::vector<bool> every_second{false, true, false, true, false, true, false, true};
    BOOST_TEST(s.initial.frozen == every_second, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(an_unknown_kind_and_a_key_of_another_kind_are_refused) {
    check_refusal(refusal_with("\"explicit\"", "\"explict\""), "initial.kind", 19, "is not known");
    const auto e = refusal_of(with_initial(pairs + "velocity_spread = 1.0\n"));
    BOOST_TEST(e.key == "scene.initial.velocity_spread");
    BOOST_TEST(e.problem == "is not a known key");
}

BOOST_AUTO_TEST_CASE(counts_and_speeds_out_of_range_are_refused) {
    const auto check = [](const std::string& text, const std::string& key) {
        const auto e = refusal_of(text);
        BOOST_TEST(e.key == "scene.initial." + key);
        BOOST_TEST(e.problem == "is out of range");
        BOOST_TEST(e.line > 13);
    };
    check(with_initial(replaced(pairs, "4", "0")), "count");
    check(with_initial(replaced(pairs, "4", "-4")), "count");
    check(with_initial(replaced(pairs, "1.0", "0")), "approach_speed");
    check(with_initial(replaced(gas, "3.0", "-3.0"), box), "velocity_spread");
    check(between_plates(replaced(bounces, "1.0", "-1.0")), "speed");
    check(between_plates(lattice + "lid_gap = 0\n"), "lid_gap");
    check(between_plates(replaced(lattice, "18", "0")), "columns");
    check(with_initial(pairs + "lead_steps = -1\n"), "lead_steps");
    const auto half = refusal_of(with_initial(replaced(pairs, "4", "4.5")));
    BOOST_TEST(half.problem == "has the wrong type");
    BOOST_TEST(half.key == "scene.initial.count");
}

BOOST_AUTO_TEST_CASE(an_impact_parameter_of_a_diameter_or_more_is_refused) {
    BOOST_CHECK_NO_THROW((void)read_scene(with_initial(pairs + "impact_parameter = 1.99\n")));
    BOOST_CHECK_NO_THROW((void)read_scene(with_initial(pairs + "impact_parameter = -1.99\n")));
    for (const std::string bad : {"2.5", "-2.5", "1e9"}) {
        const auto e = refusal_of(with_initial(pairs + "impact_parameter = " + bad + "\n"));
        BOOST_TEST_CONTEXT("impact parameter " << bad) {
            BOOST_TEST(e.key.starts_with("scene.initial"));
            BOOST_TEST(!e.problem.empty());
        }
    }
}

BOOST_AUTO_TEST_CASE(explicit_arrays_of_different_length_are_refused) {
    check_refusal(refusal_with("y = [5.0, 6.0]", "y = [5.0]"), "initial.y", 21,
                  "has the wrong length");
    check_refusal(refusal_with("vx = [0.5, 0.0]", "vx = [0.5, 0.0, 1.0]"), "initial.vx", 22,
                  "has the wrong length");
    check_refusal(refusal_with("vy = [0.0, 0.25]", "vy = 0.0"), "initial.vy", 23,
                  "has the wrong length");
    check_refusal(refusal_with("x = [1.0, 4.0]", "x = []"), "initial.x", 20, "is empty");
    check_refusal(refusal_with("x = [1.0, 4.0]", "x = [1.0, nan]"), "initial.x", 20,
                  "is out of range");
}

BOOST_AUTO_TEST_CASE(a_missing_array_is_refused_by_its_own_name) {
    // The others have similar names, and are right.
    const auto check = [](const std::string& line, const std::string& key) {
        const auto e = refusal_with(line, "\n");
        BOOST_TEST_CONTEXT("without " << key) {
            BOOST_TEST(e.key == "scene.initial." + key);
            BOOST_TEST(e.problem == "is missing");
        }
    };
    check("\nx = [1.0, 4.0]\n", "x");
    check("\ny = [5.0, 6.0]\n", "y");
    check("\nvx = [0.5, 0.0]\n", "vx");
    check("\nvy = [0.0, 0.25]\n", "vy");
}

BOOST_AUTO_TEST_CASE(frozen_grains_are_given_by_their_index) {
    const auto with_frozen = [](const std::string& list) {
        const auto at_rest = replaced(scene_text, "vy = [0.0, 0.25]", "vy = [0.0, 0.0]");
        return replaced(at_rest, "kind = \"explicit\"", "kind = \"explicit\"\nfrozen = " + list);
    };
    const std::vector<bool> second{false, true};
    BOOST_TEST(read_scene(with_frozen("[1]")).initial.frozen == second,
               boost::test_tools::per_element());
    for (const std::string bad : {"[2]", "[0, 2]", "[0.5]", "1e30"}) {
        check_refusal(refusal_of(with_frozen(bad)), "initial.frozen", 20, "names no grain");
    }
    check_refusal(refusal_of(with_frozen("[-1]")), "initial.frozen", 20, "is out of range");
}

BOOST_AUTO_TEST_CASE(a_frozen_grain_with_a_velocity_is_refused) {
    const auto e = refusal_with("kind = \"explicit\"", "kind = \"explicit\"\nfrozen = [1]");
    BOOST_TEST(e.key.starts_with("scene.initial"));
    BOOST_TEST(e.got.find("grain 1 is frozen but has a velocity") != std::string::npos, e.got);
}

BOOST_AUTO_TEST_CASE(grains_that_touch_at_the_start_are_refused) {
    const auto check = [](const CaseErrorDetails& e, const std::string& contacts) {
        check_refusal(e, "initial", 18, "cannot be made");
        BOOST_TEST(e.got.starts_with(contacts + " contacts at the start"), e.got);
    };
    check(refusal_with("x = [1.0, 4.0]", "x = [1.0, 2.5]"), "1");
    check(refusal_with("x = [1.0, 4.0]", "x = [1.0, 40.5]"), "1");  // across the period
    check(refusal_with("y = [5.0, 6.0]", "y = [0.4, 6.0]"), "1");   // in the bottom at 0.5
    check(refusal_with("y = [5.0, 6.0]", "y = [5.0, 20.5]"), "1");  // in the lid at 20
    check(refusal_with("y = [5.0, 6.0]", "y = [0.4, 20.5]"), "2");
    // Exactly touching is no contact, for grains and for plates.
    BOOST_CHECK_NO_THROW((void)read_scene(replaced(
        replaced(scene_text, "x = [1.0, 4.0]", "x = [1.0, 3.0]"), "[5.0, 6.0]", "[5.0, 5.0]")));
    BOOST_CHECK_NO_THROW((void)read_scene(replaced(scene_text, "[5.0, 6.0]", "[0.5, 20.0]")));
}

BOOST_AUTO_TEST_CASE(grains_that_do_not_fit_are_refused) {
    const auto check = [](const CaseErrorDetails& e, const std::string& words) {
        BOOST_TEST(e.key == "scene.initial");
        BOOST_TEST(e.problem == "cannot be made");
        BOOST_TEST(e.got.find(words) != std::string::npos, e.got);
        BOOST_TEST(e.line > 13);
    };
    check(refusal_of(with_initial(replaced(gas, "64", "400"), box)), "do not fit the box");
    check(refusal_of(between_plates(replaced(lattice, "18", "20"))), "do not fit the period");
    check(refusal_of(with_initial(gas)), "a gas needs periodic_x and periodic_y");
    check(refusal_of(with_initial(lattice)), "a lattice needs periodic_x and a bottom plate");
    check(refusal_of(with_initial(bounces)), "there is no bottom plate");
    check(refusal_of(with_initial(bounces + "target = \"lid\"\n")), "there is no free lid");
    check(refusal_of(between_plates(bounces + "target = \"lid\"\n")), "one grain only");
    check(refusal_of(between_plates(replaced(bounces, "4", "21"))), "contacts at the start");
}

BOOST_AUTO_TEST_CASE(more_grains_than_any_memory_holds_are_refused) {
    const auto e = refusal_of(with_initial(replaced(pairs, "4", "1000000000000000")));
    BOOST_TEST(e.key.starts_with("scene.initial"));
}
