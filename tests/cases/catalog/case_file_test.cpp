// A case file arrives as it is written; whatever is wrong with it is refused at its place, in the
// scene as well as around it; the quick suite lays its table over the rest.
#include "tests/cases/catalog/case_text.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using catalog::Suite;
using tests::case_text;
using tests::load;
using tests::refusal_of;
using tests::refusal_with;
using tests::replaced;

BOOST_AUTO_TEST_CASE(every_key_of_the_file_arrives_in_the_case) {
    const auto c = load(case_text);
    BOOST_TEST(c.name == "small");
    BOOST_TEST(c.title == "A small case");
    BOOST_TEST(c.source == "Author, section 1");
    BOOST_TEST(c.text == "What it asks.");
    BOOST_TEST(c.suites.size() == 2u);
    BOOST_TEST(c.time_limit == 60.0);
    BOOST_TEST(c.replicas.of("native-dem") == 2);
    BOOST_TEST(c.replicas.of("lammps") == 3);
    BOOST_TEST_REQUIRE(c.variants.size() == 1u);
    BOOST_TEST(c.variants[0].name.empty());
    BOOST_TEST(c.variants[0].rungs == 1u);
    BOOST_TEST_REQUIRE(c.observables.size() == 1u);
    BOOST_TEST(c.observables[0].name == "momentum");
    BOOST_TEST(c.observables[0].line == 24);
    BOOST_TEST(c.checks.size() == 1u);
    const auto scene = c.grain_scene(0, 0, 7);
    BOOST_TEST(scene.name == "small");
    BOOST_TEST(scene.seed == 7u);
    BOOST_TEST(scene.dt == 1e-3);
    BOOST_TEST(scene.grain_count() == 16u);
}

BOOST_AUTO_TEST_CASE(options_of_an_observable_arrive_with_their_place) {
    const auto c =
        load(replaced(case_text, "name = \"momentum\"",
                      "name = \"momentum\"\ntimes = [1, 2.5]\n  skip = 3\nunit = \"t\""));
    const auto& options = c.observables.at(0).options;
    BOOST_TEST(options.size() == 3u);
    BOOST_TEST(options.at("times").numbers.at(1) == 2.5);
    BOOST_TEST(options.at("skip").numbers.at(0) == 3.0);
    BOOST_TEST(options.at("skip").line == 27);
    BOOST_TEST(options.at("skip").column == 10);
    BOOST_TEST(options.at("unit").text == "t");
    BOOST_TEST(options.at("unit").numbers.empty());
}

BOOST_AUTO_TEST_CASE(replicas_are_one_unless_the_file_says_otherwise) {
    const auto c = load(replaced(case_text, "replicas = { default = 2, lammps = 3 }", ""));
    BOOST_TEST(c.replicas.of("native-dem") == 1);
    BOOST_TEST(load(replaced(case_text, "lammps = 3", "lammps = 0")).replicas.of("lammps") == 0);
    BOOST_TEST(refusal_with("default = 2", "default = 0").key == "replicas.default");
    BOOST_TEST(refusal_with("lammps = 3", "lammps = -3").key == "replicas.lammps");
}

BOOST_AUTO_TEST_CASE(a_missing_key_is_refused) {
    const auto check = [](const std::string& line, const std::string& key) {
        const auto e = refusal_with(line, "");
        BOOST_TEST(e.key == key);
        BOOST_TEST(e.problem == "is missing");
        BOOST_TEST(e.file.ends_with("small.toml"));
    };
    check("name = \"small\"", "name");
    check("title = \"A small case\"", "title");
    check("source = \"Author, section 1\"", "source");
    check("text = \"What it asks.\"", "text");
    check("suites = [\"quick\", \"full\"]", "suites");
    check("time_limit = 60.0", "time_limit");
    check("gravity = 0.0", "scene.gravity");
    check("dt = 1e-3", "scene.dt");
    check("restitution = 0.8", "scene.contact.restitution");
    check("name = \"momentum\"", "observable.name");
}

BOOST_AUTO_TEST_CASE(an_unknown_key_is_refused_where_it_stands) {
    auto e = refusal_with("title = ", "tilte = \"x\"\ntitle = ");
    BOOST_TEST(e.key == "tilte");
    BOOST_TEST(e.line == 2);
    BOOST_TEST(e.column == 1);
    BOOST_TEST(e.hint == "did you mean 'title'?");
    e = refusal_with("gravity = 0.0", "gravity = 0.0\ngravitiy = 1.0");
    BOOST_TEST(e.key == "scene.gravitiy");
    BOOST_TEST(e.line == 10);
    BOOST_TEST(e.hint == "did you mean 'gravity'?");
    e = refusal_with("[[check]]", "[[cheque]]");
    BOOST_TEST(e.key == "cheque");
    BOOST_TEST(e.line == 26);
}

BOOST_AUTO_TEST_CASE(a_wrong_type_is_refused_where_it_stands) {
    const auto check = [](const std::string& text, const std::string& key, int line) {
        const auto e = refusal_of(text);
        BOOST_TEST(e.key == key);
        BOOST_TEST(e.line == line);
        BOOST_TEST(e.problem == "has the wrong type");
    };
    check(replaced(case_text, "name = \"small\"", "name = 3"), "name", 1);
    check(replaced(case_text, "[\"quick\", \"full\"]", "\"quick\""), "suites", 5);
    check(replaced(case_text, "60.0", "\"60 s\""), "time_limit", 6);
    check(replaced(case_text, "title", "variant = 3\ntitle"), "variant", 2);
    check(replaced(case_text, "title", "quick = 3\ntitle"), "quick", 2);
    check(replaced(case_text.substr(0, case_text.find("[scene]")), "title", "scene = 3\ntitle"),
          "scene", 2);
}

BOOST_AUTO_TEST_CASE(a_time_limit_must_be_positive) {
    const auto e = refusal_with("60.0", "0");
    BOOST_TEST(e.key == "time_limit");
    BOOST_TEST(e.problem == "is out of range");
}

BOOST_AUTO_TEST_CASE(an_unknown_suite_is_refused) {
    // Such a case would never run, and nobody would notice.
    const auto e = refusal_with("\"quick\", \"full\"", "\"quikc\", \"full\"");
    BOOST_TEST(e.key == "suites");
    BOOST_TEST(e.line == 5);
}

BOOST_AUTO_TEST_CASE(the_quick_suite_lays_its_table_over_the_case) {
    const auto text = case_text + "[quick]\nreplicas = { default = 1 }\ntime_limit = 5.0\n"
                                  "[quick.scene]\ndt = 2e-3\n[quick.scene.contact]\n"
                                  "restitution = 0.5\n";
    const auto full = load(text, Suite::full), quick = load(text, Suite::quick);
    BOOST_TEST(full.grain_scene(0, 0, 1).dt == 1e-3);
    BOOST_TEST(quick.grain_scene(0, 0, 1).dt == 2e-3);
    BOOST_TEST(full.grain_scene(0, 0, 1).contact.damping <
               quick.grain_scene(0, 0, 1).contact.damping);
    BOOST_TEST(quick.grain_scene(0, 0, 1).gravity == 0.0);  // what it leaves out stays
    BOOST_TEST(full.time_limit == 60.0);
    BOOST_TEST(quick.time_limit == 5.0);
    BOOST_TEST(full.replicas.of("native-dem") == 2);
    BOOST_TEST(quick.replicas.of("native-dem") == 1);
    BOOST_TEST(quick.replicas.of("lammps") == 3);
}

BOOST_AUTO_TEST_CASE(an_unknown_key_of_the_quick_table_is_refused) {
    auto e = refusal_of(case_text + "[quick]\ntimelimit = 5.0\n", Suite::quick);
    BOOST_TEST(e.line == 33);
    BOOST_TEST(e.hint == "did you mean 'time_limit'?");
    e = refusal_of(case_text + "[quick.scene]\nperiodic = 5.0\n", Suite::quick);
    BOOST_TEST(e.key == "scene.periodic");
    BOOST_TEST(e.line == 33);
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_scene_and_another_seed_another) {
    const auto c = load(case_text);
    BOOST_TEST(c.grain_scene(0, 0, 4).initial.x == c.grain_scene(0, 0, 4).initial.x,
               boost::test_tools::per_element());
    BOOST_TEST(c.grain_scene(0, 0, 4).initial.x != c.grain_scene(0, 0, 5).initial.x,
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_case_outlives_its_file) {
    // load() has deleted the file; scenes are made later, in other threads.
    const auto copy = load(case_text);
    BOOST_CHECK_NO_THROW((void)copy.grain_scene(0, 0, 1));
}
