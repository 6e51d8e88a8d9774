// What YADE can express and what is written for it; YADE itself is not needed.
#include "adapters/yade/yade_code.hpp"
#include "cases/scene/scene_json.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <string>

using namespace crossgrain;
using namespace crossgrain::tests;
using adapters::YadeCode;

namespace {

std::string source_of(const std::string& name) {
    std::ifstream file(CROSSGRAIN_SOURCE_DIR "/adapters/yade/" + name, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    BOOST_TEST_REQUIRE(!text.empty());
    return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(expresses_every_contact_law) {
    auto scene = oblique_pair();
    for (const auto damping : {scene::Damping::full_vector, scene::Damping::normal_only}) {
        for (const auto clipping :
             {scene::Clipping::none, scene::Clipping::all, scene::Clipping::normal_only}) {
            scene.contact.damping_acts_on = damping;
            scene.contact.clipping = clipping;
            BOOST_TEST(!YadeCode().cannot_express(scene));
        }
    }
    BOOST_TEST(!YadeCode().cannot_express(small_bed()));
}

BOOST_AUTO_TEST_CASE(refuses_the_predicted_velocity) {
    auto scene = head_on_pair();
    scene.integrator = scene::Integrator::verlet_predicted;
    const auto reason = YadeCode().cannot_express(scene);
    BOOST_TEST_REQUIRE(reason.has_value());
    BOOST_TEST(reason->find("verlet-half-step") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(refuses_a_period_of_two_diameters) {
    auto scene = head_on_pair();
    scene.periodic_y = 4.0;
    const auto reason = YadeCode().cannot_express(scene);
    BOOST_TEST_REQUIRE(reason.has_value());
    BOOST_TEST(reason->find("along y") != std::string::npos);
    scene.periodic_y = 4.1;
    BOOST_TEST(!YadeCode().cannot_express(scene));
}

BOOST_AUTO_TEST_CASE(input_is_the_scripts_unchanged_and_the_scene) {
    const auto scene = small_bed();
    const auto files = YadeCode().input(scene);
    BOOST_TEST_REQUIRE(files.size() == 3U);
    BOOST_TEST(files[0].name == "scene.py");
    BOOST_TEST((files[0].text == source_of("scene.py.in")));
    BOOST_TEST(files[1].name == "scene.json");
    // Every digit of every number survives.
    BOOST_TEST((nlohmann::json::parse(files[1].text) == scene::to_json(scene)));
    BOOST_TEST(files[2].name == "plates.py");
    BOOST_TEST((files[2].text == source_of("plates.py.in")));
}

BOOST_AUTO_TEST_CASE(no_plates_no_code_for_plates) {
    BOOST_TEST(YadeCode().input(small_gas()).size() == 2U);
    BOOST_TEST(YadeCode().input(free_lid_collision()).size() == 3U);
}

BOOST_AUTO_TEST_CASE(the_script_directs_the_dump_to_the_pipe) {
    const auto files = YadeCode().input(head_on_pair());
    BOOST_TEST(files[0].text.find(std::string("'") + YadeCode::dump_name + "'") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_missing_program_is_not_installed) {
    const auto availability = YadeCode("no-such-yade").probe();
    BOOST_TEST(!availability.installed);
    BOOST_TEST(availability.reason.find("no-such-yade") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(another_program_is_not_yade) {
    const auto availability = YadeCode("true").probe();
    BOOST_TEST(!availability.installed);
    BOOST_TEST(!availability.reason.empty());
}
