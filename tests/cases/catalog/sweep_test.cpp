// A sweep makes every combination of its values a variant, with names checks can point at.
#include "tests/cases/catalog/case_text.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using catalog::Suite;
using tests::case_text;
using tests::load;
using tests::refusal_of;
using tests::replaced;

namespace {

const std::string swept = case_text + R"([sweep]
dt = [1e-3, 2e-3]
integrator = ["verlet-half-step", "verlet-predicted"]
[quick.sweep]
dt = [4e-3]
)";

std::string with_check(const std::string& extra) {
    return swept + R"([[check]]
kind = "exact"
observable = "momentum_drift_x"
against = "analytic:zero"
limit = 1.0
reason = "a test"
)" + extra;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_combination_is_a_variant_texts_first) {
    const auto c = load(swept);
    BOOST_TEST_REQUIRE(c.variants.size() == 4u);
    BOOST_TEST(c.variants[0].name == "verlet-half-step/dt=0.001");
    BOOST_TEST(c.variants[1].name == "verlet-half-step/dt=0.002");
    BOOST_TEST(c.variants[3].name == "verlet-predicted/dt=0.002");
    BOOST_TEST(c.variants[3].parameter("integrator").value() == "verlet-predicted");
    BOOST_TEST(c.variants[3].parameter("dt").value() == "0.002");
    BOOST_TEST(!c.variants[3].parameter("gravity").has_value());
    BOOST_TEST(c.grain_scene(1, 0, 1).dt == 2e-3);
    BOOST_TEST((c.grain_scene(3, 0, 1).integrator == scene::Integrator::verlet_predicted));
    BOOST_TEST((c.grain_scene(1, 0, 1).integrator == scene::Integrator::verlet_half_step));
}

BOOST_AUTO_TEST_CASE(the_quick_suite_replaces_the_values_of_a_key) {
    const auto c = load(swept, Suite::quick);
    BOOST_TEST_REQUIRE(c.variants.size() == 2u);
    BOOST_TEST(c.variants[1].name == "verlet-predicted/dt=0.004");
    BOOST_TEST(c.grain_scene(1, 0, 1).dt == 4e-3);
}

BOOST_AUTO_TEST_CASE(keys_inside_tables_and_all_words_of_a_key_can_be_swept) {
    const auto c = load(case_text + "[sweep]\ncontact.restitution = [0.5, 0.9]\n"
                                    "precision = [\"*\"]\n");
    BOOST_TEST_REQUIRE(c.variants.size() == 4u);
    BOOST_TEST(c.variants[1].name == "double/restitution=0.9");
    BOOST_TEST(c.variants[2].name == "mixed/restitution=0.5");
    BOOST_TEST(c.variants[2].parameter("restitution").value() == "0.5");
    BOOST_TEST(c.grain_scene(0, 0, 1).contact.damping > c.grain_scene(1, 0, 1).contact.damping);
    BOOST_TEST((c.grain_scene(2, 0, 1).precision == scene::Precision::mixed));
}

BOOST_AUTO_TEST_CASE(a_chart_has_a_ladder_and_variants_of_its_own) {
    const std::string text = swept + R"([chart.sweep]
dt = [5e-3]
[[chart.variant]]
name = "soft"
drops = "stiffness"
scene.contact.contact_time = 0.4
[[chart.error]]
observable = "momentum_drift_x"
against = "analytic:zero"
margin = 1.0
reason = "a test"
)";
    const auto c = load(text, Suite::chart);
    BOOST_TEST_REQUIRE(c.variants.size() == 1u);
    BOOST_TEST(c.variants[0].name == "dt=0.005/soft");
    BOOST_TEST(c.variants[0].drops == "stiffness");
    BOOST_TEST(contact_time(c.grain_scene(0, 0, 1)) > 0.3);
    BOOST_TEST(c.checks.empty());
    BOOST_TEST_REQUIRE(c.charted.size() == 1u);
    BOOST_TEST(c.charted[0].margin == 1.0);
    // The case itself knows nothing of it.
    BOOST_TEST(load(text).variants.size() == 4u);
    BOOST_TEST(refusal_of(replaced(text, "analytic:zero\"\nmargin", "paper\"\nmargin")).key ==
               "error.against");
}

BOOST_AUTO_TEST_CASE(written_variants_are_crossed_with_the_sweep) {
    const auto c = load(swept + "[[variant]]\nname = \"hard\"\nscene.contact.contact_time = 0.05\n"
                                "[[variant]]\nname = \"soft\"\n");
    BOOST_TEST_REQUIRE(c.variants.size() == 8u);
    BOOST_TEST(c.variants[2].name == "verlet-half-step/dt=0.002/hard");
    BOOST_TEST(contact_time(c.grain_scene(2, 0, 1)) < 0.06);
    BOOST_TEST(c.grain_scene(2, 0, 1).dt == 2e-3);
    BOOST_TEST(contact_time(c.grain_scene(3, 0, 1)) > 0.09);
}

BOOST_AUTO_TEST_CASE(a_variant_may_be_limited_to_some_points_of_the_sweep) {
    const std::string limited = swept +
                                "[[variant]]\nname = \"hard\"\nonly = { dt = [\"0.002\"] }\n"
                                "scene.contact.contact_time = 0.05\n"
                                "[[variant]]\nname = \"soft\"\n";
    const auto c = load(replaced(limited, "[quick.sweep]\ndt = [4e-3]\n", ""));
    BOOST_TEST_REQUIRE(c.variants.size() == 6u);
    BOOST_TEST(c.variants[0].name == "verlet-half-step/dt=0.001/soft");
    BOOST_TEST(c.variants[1].name == "verlet-half-step/dt=0.002/hard");
    BOOST_TEST(contact_time(c.grain_scene(1, 0, 1)) < 0.06);
    BOOST_TEST(contact_time(c.grain_scene(2, 0, 1)) > 0.09);
    BOOST_TEST(c.grain_scene(5, 0, 1).dt == 2e-3);
    // A limit that no point meets would leave the variant out for ever.
    BOOST_TEST(refusal_of(replaced(limited, "0.002\"", "0.003\"")).key == "variant.only.dt");
    BOOST_TEST(refusal_of(replaced(limited, "dt = [\"", "gravity = [\"")).key ==
               "variant.only.gravity");
}

BOOST_AUTO_TEST_CASE(a_key_of_a_table_of_the_scene_is_swept_by_its_path) {
    const auto c = load(case_text + "[sweep]\n\"initial.velocity_spread\" = [1.0, 2.0]\n"
                                    "\"contact.restitution\" = [0.9, 1.0]\n");
    BOOST_TEST_REQUIRE(c.variants.size() == 4u);
    BOOST_TEST(c.variants[1].name == "velocity_spread=1/restitution=1");
    BOOST_TEST(c.variants[2].parameter("velocity_spread").value() == "2");
    BOOST_TEST(c.grain_scene(1, 0, 1).contact.damping == 0.0);
    BOOST_TEST(c.grain_scene(2, 0, 1).contact.damping > 0.0);
    const double slow = c.grain_scene(0, 0, 1).initial.vx[0];
    BOOST_TEST(c.grain_scene(2, 0, 1).initial.vx[0] == 2 * slow);
    // What the reader refuses is placed at the sweep's key.
    const auto e = refusal_of(case_text + "[sweep]\n\"contact.restitution\" = [0.9, 1.5]\n");
    BOOST_TEST(e.key == "scene.contact.restitution");
    BOOST_TEST(e.line > 20);
}

BOOST_AUTO_TEST_CASE(checks_point_at_variants_by_patterns) {
    BOOST_TEST(catalog::matches("P/*", "P/p=0.1"));
    BOOST_TEST(!catalog::matches("P/*", "D/p=0.1"));
    BOOST_TEST(catalog::matches("*/p=0.1", "D/p=0.1"));
    BOOST_TEST(!catalog::matches("p=0.1", "p=0.15"));
    const auto c = load(with_check("variants = [\"*/dt=0.001\"]\n"
                                   "expect_in = { \"*predicted*\" = \"disagree\" }\n"
                                   "expect_reason = \"a test\"\n"));
    BOOST_TEST(c.checks.back().variants.front() == "*/dt=0.001");
    BOOST_TEST(c.checks.back().expect_in.at("*predicted*") == "disagree");
}

BOOST_AUTO_TEST_CASE(a_pattern_that_no_variant_matches_is_refused) {
    const auto e = refusal_of(with_check("variants = [\"*/dt=0.003\"]\n"));
    BOOST_TEST(e.key == "check.variants");
    BOOST_TEST(e.expected.find("verlet-predicted/dt=0.001") != std::string::npos);
    BOOST_TEST(refusal_of(with_check("expect_in = { \"P/*\" = \"disagree\" }\n"
                                     "expect_reason = \"a test\"\n"))
                   .key == "check.expect_in");
}

BOOST_AUTO_TEST_CASE(a_trend_is_asked_along_a_key_of_the_sweep) {
    const std::string trend = swept + R"([[check]]
kind = "published"
observable = "momentum_drift_x"
against = "published:x/y"
aspect = "constant"
along = "dt"
limit = 1.0
reason = "a test"
)";
    const auto c = load(trend);
    BOOST_TEST((c.checks.back().aspect == catalog::Aspect::constant));
    BOOST_TEST(c.checks.back().along == "dt");
    BOOST_TEST(refusal_of(replaced(trend, "along = \"dt\"", "along = \"density\"")).key ==
               "check.along");
    BOOST_TEST(refusal_of(replaced(trend, "along = \"dt\"\n", "")).key == "check.along");
    BOOST_TEST(refusal_of(replaced(trend, "kind = \"published\"", "kind = \"agree\"")).key ==
               "check.aspect");
}

BOOST_AUTO_TEST_CASE(a_sweep_that_makes_no_sense_is_refused_with_its_place) {
    const auto refused = [](const std::string& what, const std::string& by) {
        return refusal_of(replaced(swept, what, by));
    };
    const auto twice = refused("[1e-3, 2e-3]", "[1e-3, 1e-3]");
    BOOST_TEST(twice.key == "sweep.dt");
    BOOST_TEST(twice.line == 33);
    BOOST_TEST(refused("[1e-3, 2e-3]", "[]").key == "sweep.dt");
    BOOST_TEST(refused("[1e-3, 2e-3]", "1e-3").key == "sweep.dt");
    BOOST_TEST(refused("[1e-3, 2e-3]", "[1e-3, \"fast\"]").key == "sweep.dt");
    BOOST_TEST(refused("dt = [4e-3]", "gravity = [1.0]").key == "sweep.gravity");
    // What the scene's reader refuses is placed at the sweep's key.
    const auto negative = refused("[1e-3, 2e-3]", "[1e-3, -2e-3]");
    BOOST_TEST(negative.key == "scene.dt");
    BOOST_TEST(negative.line == 33);
}
