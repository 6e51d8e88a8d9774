// Variants are laid over the scene, quick and case below them; each has its ladder of time steps.
#include "tests/cases/catalog/case_text.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

namespace tt = boost::test_tools;
using namespace crossgrain;
using catalog::Suite;
using tests::case_text;
using tests::load;
using tests::refusal_of;
using tests::replaced;

namespace {

const std::string two_variants = case_text + R"([[variant]]
name = "hard"
scene.contact.contact_time = 0.05
[[variant]]
name = "ladder"
not_expressible_in = ["yade", "lammps"]
scene.dt = [1e-3, 5e-4, 2.5e-4]
)";

}  // namespace

BOOST_AUTO_TEST_CASE(a_variant_is_laid_over_the_scene) {
    const auto c = load(two_variants);
    BOOST_TEST_REQUIRE(c.variants.size() == 2u);
    BOOST_TEST(c.variants[0].name == "hard");
    BOOST_TEST(c.variants[0].rungs == 1u);
    BOOST_TEST(c.variants[0].not_expressible_in.empty());
    BOOST_TEST(contact_time(c.grain_scene(0, 0, 1)) == 0.05, tt::tolerance(1e-14));
    BOOST_TEST(contact_time(c.grain_scene(1, 0, 1)) == 0.1, tt::tolerance(1e-14));
    BOOST_TEST(c.grain_scene(0, 0, 1).dt == 1e-3);  // what it leaves out stays
}

BOOST_AUTO_TEST_CASE(a_variant_can_have_more_replicas_than_the_others) {
    const auto c = load(replaced(two_variants, "[scene]", "replicas_in = { hard = 5 }\n[scene]"));
    BOOST_TEST(c.replicas.of("lammps", "hard") == 15);
    BOOST_TEST(c.replicas.of("lammps", "ladder") == 3);
    BOOST_TEST(c.replicas.of("native-dem", "hard") == 10);
    BOOST_TEST(
        refusal_of(replaced(two_variants, "[scene]", "replicas_in = { heavy = 5 }\n[scene]")).key ==
        "replicas_in");
}

BOOST_AUTO_TEST_CASE(a_ladder_has_one_scene_per_time_step) {
    const auto c = load(two_variants);
    BOOST_TEST(c.variants[1].rungs == 3u);
    BOOST_TEST(c.variants[1].not_expressible_in.at(1) == "lammps");
    BOOST_TEST(c.grain_scene(1, 0, 1).dt == 1e-3);
    BOOST_TEST(c.grain_scene(1, 1, 1).dt == 5e-4);
    BOOST_TEST(c.grain_scene(1, 2, 1).dt == 2.5e-4);
    BOOST_TEST(c.grain_scene(1, 2, 1).steps == 4000);
}

BOOST_AUTO_TEST_CASE(scenes_are_named_by_case_variant_and_rung) {
    const auto c = load(two_variants);
    BOOST_TEST(c.grain_scene(0, 0, 1).name == "small/hard");
    BOOST_TEST(c.grain_scene(1, 0, 1).name == "small/ladder/1");
    BOOST_TEST(c.grain_scene(1, 2, 1).name == "small/ladder/3");
    BOOST_TEST(load(case_text).grain_scene(0, 0, 1).name == "small");
}

BOOST_AUTO_TEST_CASE(a_variant_wins_over_the_quick_table_and_that_over_the_case) {
    const auto text = two_variants + "[quick.scene]\ndt = 2e-3\nperiodic_x = 25.0\n";
    const auto quick = load(text, Suite::quick);
    BOOST_TEST(quick.grain_scene(0, 0, 1).dt == 2e-3);
    BOOST_TEST(quick.grain_scene(1, 0, 1).dt == 1e-3);
    BOOST_TEST(quick.variants[1].rungs == 3u);
    BOOST_TEST(quick.grain_scene(1, 0, 1).periodic_x.value() == 25.0);
}

BOOST_AUTO_TEST_CASE(every_variant_s_scene_is_checked_when_the_case_is_loaded) {
    const auto e = refusal_of(
        replaced(two_variants, "scene.contact.contact_time", "scene.contact.contat_time"));
    BOOST_TEST(e.key == "scene.contact.contat_time");
    BOOST_TEST(e.line == 34);
    BOOST_TEST(e.hint == "did you mean 'contact_time'?");
    const auto rung = refusal_of(replaced(two_variants, "2.5e-4]", "-2.5e-4]"));
    BOOST_TEST(rung.key == "scene.dt");
    BOOST_TEST(rung.line == 38);
}

BOOST_AUTO_TEST_CASE(a_broken_variant_is_refused) {
    auto e = refusal_of(replaced(two_variants, "name = \"hard\"", ""));
    BOOST_TEST(e.key == "variant.name");
    BOOST_TEST(e.problem == "is missing");
    e = refusal_of(replaced(two_variants, "not_expressible_in", "not_expresible_in"));
    BOOST_TEST(e.key == "variant.not_expresible_in");
    BOOST_TEST(e.line == 37);
    BOOST_TEST(e.hint == "did you mean 'not_expressible_in'?");
    e = refusal_of(replaced(two_variants, "scene.contact.contact_time = 0.05", "scene = 3"));
    BOOST_TEST(e.key == "variant.scene");
    BOOST_TEST(e.problem == "has the wrong type");
}

BOOST_AUTO_TEST_CASE(two_variants_of_one_name_are_refused) {
    // Their runs and verdicts could not be told apart.
    const auto e = refusal_of(replaced(two_variants, "name = \"ladder\"", "name = \"hard\""));
    BOOST_TEST(e.key == "variant.name");
}
