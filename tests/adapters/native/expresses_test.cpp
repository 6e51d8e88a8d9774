// What the native engine can express it takes; what it cannot it refuses with the reason, and its
// input says all there is to know about the run.
#include "adapters/native/native_dem_code.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using adapters::NativeDemCode;

namespace {

const NativeDemCode code("0.1.0 (engine 1a2b3c4d)");

std::string reason(const scene::Scene& s) {
    return code.cannot_express(s).value_or("");
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_is_always_installed_with_the_version_it_was_built_with) {
    BOOST_TEST(code.name() == "native-dem");
    BOOST_TEST(code.probe().installed);
    BOOST_TEST(code.probe().version == "0.1.0 (engine 1a2b3c4d)");
    BOOST_TEST(code.probe().reason.empty());
    BOOST_TEST(!code.features().empty());
}

BOOST_AUTO_TEST_CASE(it_expresses_every_law_without_spins) {
    for (auto s : {tests::head_on_pair(), tests::small_bed(), tests::doubly_periodic_gas(),
                   tests::prescribed_lid(), tests::frozen_target()}) {
        for (const auto damping : {scene::Damping::full_vector, scene::Damping::normal_only}) {
            for (const auto clipping :
                 {scene::Clipping::none, scene::Clipping::all, scene::Clipping::normal_only}) {
                s.contact.damping_acts_on = damping;
                s.contact.clipping = clipping;
                s.integrator = scene::Integrator::verlet_predicted;
                BOOST_TEST(reason(s) == "");
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(it_expresses_every_integrator_and_both_kinds_of_contacts) {
    auto s = tests::small_bed();
    for (int i = 0; i <= static_cast<int>(scene::Integrator::taguchi_adaptive_euler); ++i) {
        s.integrator = static_cast<scene::Integrator>(i);
        for (const auto contacts :
             {scene::Contacts::neighbour_list, scene::Contacts::lattice_neighbours}) {
            s.contacts = contacts;
            BOOST_TEST(reason(s) == "");
        }
    }
}

BOOST_AUTO_TEST_CASE(it_refuses_mixed_precision_where_its_kernel_lacks_something) {
    auto s = tests::small_bed();
    s.precision = scene::Precision::mixed;
    s.integrator = scene::Integrator::runge_kutta_4;
    BOOST_TEST(reason(s).find("precision = \"double\"") != std::string::npos, reason(s));
}

BOOST_AUTO_TEST_CASE(it_refuses_spins_and_says_so) {
    auto s = tests::head_on_pair();
    s.contact.spins = scene::Spins::on;
    BOOST_TEST(reason(s).find("no rotating discs") != std::string::npos, reason(s));
    BOOST_TEST(reason(s).find('\n') == std::string::npos);
}

BOOST_AUTO_TEST_CASE(it_refuses_a_period_below_three_diameters) {
    // Its list would miss the second image.
    auto s = tests::head_on_pair();
    s.periodic_x = 6;
    s.periodic_y = 6;
    BOOST_TEST(reason(s) == "");
    s.periodic_x = 5.999;
    BOOST_TEST(reason(s).find("3 diameters") != std::string::npos, reason(s));
    s.periodic_x = 6;
    s.periodic_y = 5.999;
    BOOST_TEST(reason(s).find("3 diameters") != std::string::npos, reason(s));
}

BOOST_AUTO_TEST_CASE(its_input_changes_with_the_scene_and_with_nothing_else) {
    const auto input = code.input(tests::small_bed());
    BOOST_TEST_REQUIRE(input.size() == 1u);
    BOOST_TEST(input[0].name == "scene.json");
    BOOST_TEST(input[0].text == code.input(tests::small_bed())[0].text);
    auto other = tests::small_bed();
    other.initial.x[3] += 1e-15;
    BOOST_TEST(input[0].text != code.input(other)[0].text);
}
