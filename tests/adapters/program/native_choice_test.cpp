// Foreign codes refuse what only the native engine offers, and name what they could do instead.
#include "adapters/program/native_choice.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;

namespace {

std::string reason(const scene::Scene& scene) {
    return adapters::native_choice(scene).value_or("");
}

}  // namespace

BOOST_AUTO_TEST_CASE(usual_scenes_are_nobody_s_privilege) {
    BOOST_TEST(reason(tests::head_on_pair()) == "");
    BOOST_TEST(reason(tests::small_bed()) == "");
}

BOOST_AUTO_TEST_CASE(fixed_neighbours_are_refused) {
    auto scene = tests::small_bed();
    scene.contacts = scene::Contacts::lattice_neighbours;
    BOOST_TEST(reason(scene).find("contacts neighbour-list") != std::string::npos, reason(scene));
}

BOOST_AUTO_TEST_CASE(mixed_precision_is_refused) {
    auto scene = tests::small_bed();
    scene.precision = scene::Precision::mixed;
    BOOST_TEST(reason(scene).find("precision double") != std::string::npos, reason(scene));
}
