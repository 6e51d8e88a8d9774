// A hopper's JSON identifies a run: every field that decides a number changes it, a label does not.
#include "cases/scene/model_json.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

using namespace crossgrain;
using scene::HopperAutomaton;

namespace {

HopperAutomaton hopper() {
    return {.name = "test",
            .outlet = 20,
            .levels = 800,
            .angles = {10, 40},
            .c_d = 0.01,
            .c_o = 0,
            .c_i = 0.1,
            .c_w = 10,
            .iterations = 100,
            .every = 50};
}

void raise(double& value) {
    value = std::nextafter(value, 1e300);
}

const std::vector<std::function<void(HopperAutomaton&)>> mutations{
    [](HopperAutomaton& s) { s.reading.sweep = scene::HopperSweep::top_to_bottom; },
    [](HopperAutomaton& s) { s.reading.rows = scene::HopperRows::zigzag; },
    [](HopperAutomaton& s) { s.reading.inertia = scene::HopperInertia::literal; },
    [](HopperAutomaton& s) { s.reading.rotation = false; },
    [](HopperAutomaton& s) { raise(s.reading.tie_tolerance); },
    [](HopperAutomaton& s) { ++s.outlet; },
    [](HopperAutomaton& s) { ++s.levels; },
    [](HopperAutomaton& s) { raise(s.angles[1]); },
    [](HopperAutomaton& s) { s.angles.pop_back(); },
    [](HopperAutomaton& s) { raise(s.c_d); },
    [](HopperAutomaton& s) { raise(s.c_o); },
    [](HopperAutomaton& s) { raise(s.c_i); },
    [](HopperAutomaton& s) { raise(s.c_w); },
    [](HopperAutomaton& s) { ++s.iterations; },
    [](HopperAutomaton& s) { ++s.every; },
    [](HopperAutomaton& s) { ++s.replicas; },
    [](HopperAutomaton& s) { ++s.flipped; },
    [](HopperAutomaton& s) { s.random = scene::HopperRandom::shared_stream; },
    [](HopperAutomaton& s) { s.engine = scene::HopperEngine::plain; },
    [](HopperAutomaton& s) { ++s.seed; },
};

}  // namespace

BOOST_AUTO_TEST_CASE(every_field_that_decides_a_number_changes_the_identity) {
    std::set<std::string> texts{scene::to_json(hopper()).dump()};
    for (const auto& apply : mutations) {
        auto s = hopper();
        apply(s);
        BOOST_TEST(texts.insert(scene::to_json(s).dump()).second);
    }
}

BOOST_AUTO_TEST_CASE(the_reading_s_name_does_not_change_the_identity) {
    auto s = hopper();
    s.reading.name = "the same rules under another name";
    BOOST_TEST(scene::to_json(s).dump() == scene::to_json(hopper()).dump());
}

BOOST_AUTO_TEST_CASE(readers_see_the_ends_of_a_long_sweep) {
    auto s = hopper();
    BOOST_TEST(scene::settings_json(s)["angles"].dump() == "[10.0,40.0]");
    s.angles.assign(801, 50);
    s.angles.front() = 10;
    s.angles.back() = 90;
    BOOST_TEST(scene::settings_json(s)["angles"].get<std::string>() == "801 from 10 to 90");
}
