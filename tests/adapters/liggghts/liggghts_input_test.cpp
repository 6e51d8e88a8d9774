// What LIGGGHTS is told of friction, and what it refuses; LIGGGHTS itself is not needed.
#include "adapters/liggghts/liggghts_code.hpp"
#include "tests/support/frictional_suite.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using namespace crossgrain::tests;
using adapters::LiggghtsCode;
using scene::Clipping;

namespace {

std::string script_of(const scene::Scene& scene) {
    return input_text(LiggghtsCode(), scene, "in.liggghts");
}

bool holds(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

std::string pair_style(const scene::ContactLaw& law) {
    const std::string script = script_of(frictional_pairs(law));
    const std::size_t start = script.find("pair_style gran model ");
    return script.substr(start, script.find('\n', start) - start);
}

bool refused(const scene::Scene& scene, const std::string& because) {
    return refuses(LiggghtsCode(), scene, because);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_law_has_its_words) {
    const std::string model = "pair_style gran model hooke/stiffness tangential ";
    BOOST_TEST(pair_style(frictional_law()) ==
               model + "history tangential_damping off limitForce on absolute_damping on");
    BOOST_TEST(pair_style(frictional_law(5, Clipping::none)) ==
               model + "history absolute_damping on");
    BOOST_TEST(pair_style(dashpot_law()) == model + "no_history limitForce on absolute_damping on");
    auto per_mass = frictional_law(5);
    per_mass.damping_scale = scene::DampingScale::effective_mass;
    BOOST_TEST(pair_style(per_mass) == model + "history limitForce on absolute_damping off");
}

BOOST_AUTO_TEST_CASE(a_law_with_history_never_lacks_the_contact_distance_factor) {
    const std::string factor = "neigh_modify contact_distance_factor 1.05\n";
    BOOST_TEST(holds(script_of(frictional_pairs(frictional_law())), factor));
    BOOST_TEST(holds(script_of(frictional_pairs(frictional_law(5, Clipping::none))), factor));
    BOOST_TEST(!holds(script_of(frictional_pairs(dashpot_law())), factor));
}

BOOST_AUTO_TEST_CASE(the_moment_of_inertia_is_a_number_of_dimensions) {
    auto law = frictional_law();
    BOOST_TEST(holds(script_of(frictional_pairs(law)), "dimension 3\nboundary s s f\n"));
    law.friction->inertia_factor = disc;
    BOOST_TEST(holds(script_of(frictional_pairs(law)), "dimension 2\nboundary s s p\n"));
    law.friction->inertia_factor = 0.45;
    BOOST_TEST(refused(frictional_pairs(law), "inertia_factor 0.5 or 0.4 would be expressible"));
}

BOOST_AUTO_TEST_CASE(frozen_grains_are_held_where_their_mass_would_count) {
    const std::string freeze = "group frozen type 2\nfix hold frozen freeze\n";
    auto law = frictional_law();
    BOOST_TEST(!holds(script_of(frictional_pairs(law)), freeze));
    law.damping_scale = scene::DampingScale::effective_mass;
    BOOST_TEST(holds(script_of(frictional_pairs(law)), freeze));
}

BOOST_AUTO_TEST_CASE(drag_and_backing_planes_only_where_there_are_any) {
    const std::string plane = "fix backing grains addforce v_backing 0 0";
    const std::string pipe = script_of(pipe_in_small(frictional_law()));
    BOOST_TEST(holds(pipe, plane));
    BOOST_TEST(holds(pipe, "viscous 0.05"));
    const std::string gas = script_of(frictional_gas(frictional_law()));
    BOOST_TEST(!holds(gas, "backing"));
    BOOST_TEST(!holds(gas, "viscous"));
}

BOOST_AUTO_TEST_CASE(other_conventions_are_refused) {
    auto law = frictional_law(5);
    law.friction->conventions = scene::conventions_named("liggghts");
    BOOST_TEST(!LiggghtsCode().cannot_express(frictional_pairs(law)));
    for (const char* other : {"lammps-granular", "lammps-hooke-history", "yade"}) {
        law.friction->conventions = scene::conventions_named(other);
        BOOST_TEST(refused(frictional_pairs(law), other));
        BOOST_TEST(refused(frictional_pairs(law), "conventions liggghts or own"));
    }
}

BOOST_AUTO_TEST_CASE(plates_that_touch_surfaces_of_grains_that_differ_are_refused) {
    auto scene = grain_in_a_valley(frictional_law());
    scene.grains.diameters[0] = 1.9;
    scene.plates = {.stiffness = stiffness,
                    .touches = scene::PlateContact::surface,
                    .bottom = scene::PrescribedPlate{.height = -1.0},
                    .lid = {}};
    BOOST_TEST(refused(scene, "touch centres"));
    scene.plates.touches = scene::PlateContact::centre;
    BOOST_TEST(!LiggghtsCode().cannot_express(scene));
}
