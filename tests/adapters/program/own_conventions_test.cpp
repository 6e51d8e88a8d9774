// Which conventions of friction a code may call its own: those that make the same force.
#include "adapters/program/own_conventions.hpp"
#include "tests/support/frictional_scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using adapters::same_force;
using tests::dashpot_law;
using tests::frictional_law;

namespace {

scene::FrictionConventions named(const std::string& name) {
    return scene::conventions_named(name).value();
}

bool same(const scene::ContactLaw& law, const std::string& a, const std::string& b) {
    return same_force(*law.friction, named(a), named(b));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_spring_is_turned_differently) {
    BOOST_TEST(same(frictional_law(), "yade", "yade"));
    BOOST_TEST(!same(frictional_law(), "liggghts", "yade"));
    BOOST_TEST(!same(frictional_law(), "lammps-granular", "lammps-hooke-history"));
}

BOOST_AUTO_TEST_CASE(without_history_only_the_levers_matter) {
    BOOST_TEST(same(dashpot_law(), "liggghts", "yade"));
    BOOST_TEST(!same(dashpot_law(), "liggghts", "lammps-hooke-history"));
}

BOOST_AUTO_TEST_CASE(what_is_limited_matters_where_spring_and_dashpot_add_up) {
    auto total = named("liggghts");
    total.limit = scene::CoulombLimit::total;
    BOOST_TEST(same_force(*frictional_law().friction, named("liggghts"), total));
    BOOST_TEST(!same_force(*frictional_law(5).friction, named("liggghts"), total));
}

BOOST_AUTO_TEST_CASE(a_refusal_names_both) {
    auto scene = tests::frictional_pairs(frictional_law());
    BOOST_TEST(!adapters::foreign_conventions(scene, "yade"));
    scene.contact.friction->conventions = named("lammps-granular");
    const std::string reason = adapters::foreign_conventions(scene, "yade").value_or("");
    BOOST_TEST(reason.find("not as in lammps-granular") != std::string::npos, reason);
    BOOST_TEST(reason.find("conventions yade or own") != std::string::npos, reason);
    BOOST_TEST(!adapters::foreign_conventions(scene, "lammps-granular"));
    BOOST_TEST(!adapters::foreign_conventions(tests::small_gas(), "yade"));
}
