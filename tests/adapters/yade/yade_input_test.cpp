// What YADE can express and what is written for it; YADE itself is not needed.
#include "adapters/yade/yade_code.hpp"
#include "cases/scene/scene_json.hpp"
#include "tests/support/frictional_suite.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <string>

using namespace crossgrain;
using namespace crossgrain::tests;
using adapters::YadeCode;
using scene::Clipping;

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
    auto unequal = frictional_pairs(frictional_law());
    unequal.periodic_y = 4.1;
    BOOST_TEST(!YadeCode().cannot_express(unequal));
    unequal.grains.diameters[0] = 2.1;  // the largest counts
    BOOST_TEST(refuses(YadeCode(), unequal, "along y"));
}

BOOST_AUTO_TEST_CASE(input_is_the_scripts_unchanged_and_the_scene) {
    const auto scene = small_bed();
    const auto files = YadeCode().input(scene);
    BOOST_TEST_REQUIRE(files.size() == 4U);
    BOOST_TEST(files[0].name == "scene.py");
    BOOST_TEST((files[0].text == source_of("scene.py.in")));
    BOOST_TEST(files[1].name == "scene.json");
    // Every digit of every number survives; the name, a text from outside, is left out.
    nlohmann::json expected = scene::to_json(scene);
    expected.erase("name");
    BOOST_TEST((nlohmann::json::parse(files[1].text) == expected));
    BOOST_TEST(files[2].name == "laws.py");
    BOOST_TEST((files[2].text == source_of("laws.py.in")));
    BOOST_TEST(files[3].name == "plates.py");
    BOOST_TEST((files[3].text == source_of("plates.py.in")));
}

BOOST_AUTO_TEST_CASE(no_plates_no_code_for_plates) {
    BOOST_TEST(YadeCode().input(small_gas()).size() == 3U);
    BOOST_TEST(YadeCode().input(free_lid_collision()).size() == 4U);
    BOOST_TEST(YadeCode().input(pipe_in_small(frictional_law())).size() == 4U);
}

BOOST_AUTO_TEST_CASE(expresses_friction_in_its_own_conventions) {
    for (auto law : {frictional_law(5), dashpot_law(), frictional_law(damping, Clipping::none)}) {
        BOOST_TEST(!YadeCode().cannot_express(frictional_pairs(law)));
        law.friction->conventions = scene::conventions_named("yade");
        BOOST_TEST(!YadeCode().cannot_express(frictional_pairs(law)));
        law.friction->conventions = scene::conventions_named("lammps-granular");
        BOOST_TEST(refuses(YadeCode(), frictional_pairs(law), "conventions yade or own"));
    }
    // It turns a spring in its own way. Without a spring there is no difference to LIGGGHTS.
    auto law = frictional_law();
    law.friction->conventions = scene::conventions_named("liggghts");
    BOOST_TEST(refuses(YadeCode(), frictional_pairs(law), "not as in liggghts"));
    law = dashpot_law();
    law.friction->conventions = scene::conventions_named("liggghts");
    BOOST_TEST(!YadeCode().cannot_express(frictional_pairs(law)));
}

BOOST_AUTO_TEST_CASE(refuses_what_luding_s_law_is_not) {
    BOOST_TEST(refuses(YadeCode(), frictional_pairs(frictional_law(5, Clipping::none)),
                       "tangential damping of 2.23144"));
    BOOST_TEST(refuses(YadeCode(), frictional_pairs(dashpot_law(Clipping::none)),
                       "no Coulomb limit on a dashpot"));
    // Without a dashpot there is no attraction to keep.
    for (auto law : {frictional_law(5, Clipping::none), dashpot_law(Clipping::none)}) {
        law.damping = 0;
        BOOST_TEST(!YadeCode().cannot_express(frictional_pairs(law)));
    }
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
