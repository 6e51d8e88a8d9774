// A rule table that breaks a conservation law, or that says more than one thing, never becomes a
// run; the shipped readings are what the facts about the paper say.
#include "cases/scene/collision_notation.hpp"
#include "tests/cases/scene/gas_text.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <map>
#include <string>

using namespace crossgrain;
using tests::read_rows;

namespace {

scene::GasReading shipped(const std::string& name) {
    return scene::load_gas_reading(tests::shipped_readings + "/" + name + ".toml");
}

/// Probability at p of the outcome, summed over the rows that give it; 0 if there is none.
double probability(const scene::GasReading& reading, const std::string& from, const std::string& to,
                   double p) {
    const scene::SiteState before = scene::site_of(scene::parse_site(from), 0, false);
    const scene::SiteState after = scene::site_of(scene::parse_site(to), 0, false);
    double sum = 0;
    for (const auto& row : reading.rows) {
        if (row.before == before && row.after == after) sum += row.probability.at(p);
    }
    return sum;
}

CaseErrorDetails row_refusal(const std::string& rows) {
    return tests::refusal([&] { (void)read_rows(rows); });
}

void check_row(const std::string& rows, const std::string& key, int line,
               const std::string& problem) {
    const auto e = row_refusal(rows);
    BOOST_TEST_CONTEXT(rows) {
        BOOST_TEST(e.key == key);
        BOOST_TEST(e.line == line);
        BOOST_TEST(e.problem == problem);
        BOOST_TEST(e.file.ends_with(".toml"));
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_row_of_the_shipped_readings_conserves_mass_and_momentum) {
    for (const char* name : {"P", "D", "M", "std"}) {
        const auto reading = shipped(name);
        BOOST_TEST(reading.name == name);
        BOOST_TEST(!reading.rows.empty());
        for (const auto& row : reading.rows) {
            BOOST_TEST(scene::mass(row.before) == scene::mass(row.after));
            BOOST_TEST(scene::momentum(row.before) == scene::momentum(row.after));
        }
    }
}

BOOST_AUTO_TEST_CASE(reading_p_is_the_table_of_the_facts) {
    const auto p = shipped("P");
    // 3 head-on pairs with 3 outcomes, 6 pairs at 120 degrees, 2 triples with 2 outcomes, and the
    // 3 + 2 with a particle at rest.
    BOOST_TEST(p.rows.size() == 9U + 6U + 4U + 5U);
    BOOST_TEST(probability(p, "0 3", "1 4", 0.8) == 0.1, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(probability(p, "0 3", "2 5", 0.8) == 0.1, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(probability(p, "0 3", "R R", 0.8) == 0.8);
    BOOST_TEST(probability(p, "5 1", "0 R", 0.8) == 0.8);
    BOOST_TEST(probability(p, "0 2 4", "1 3 5", 0.25) == 0.75);
    BOOST_TEST(probability(p, "1 3 5", "R R R", 0.25) == 0.25);
    BOOST_TEST(probability(p, "2 5 R", "R R R", 0.1) == 1);
    BOOST_TEST(probability(p, "0 2 4 R", "R R R R", 0.1) == 1);
    BOOST_TEST((p.walls == scene::WallPlace::outside));
    BOOST_TEST((p.relocation == scene::Relocation::origin_first));
    BOOST_TEST(p.gravity.up_to_rest);
    BOOST_TEST(!p.gravity.on_walls);
}

BOOST_AUTO_TEST_CASE(reading_m_splits_resting_particles_and_lets_others_watch) {
    const auto m = shipped("M");
    BOOST_TEST(probability(m, "3 R", "2 4", 0.9) == 0.1);
    BOOST_TEST(probability(m, "0 2 R", "1 R R", 0.9) == 1);
    BOOST_TEST(probability(m, "0 2", "1 R", 0.9) == 0);
    for (const auto& row : m.rows) {
        const bool lone = scene::mass(row.before) == 2 && row.before.rests == 1;
        const bool triple = row.before.movers == 0b010101 || row.before.movers == 0b101010;
        BOOST_TEST((row.matching == scene::Matching::exact) == (lone || triple));
    }
}

BOOST_AUTO_TEST_CASE(std_is_d_without_the_collision_at_120_degrees) {
    const auto d = shipped("D"), standard = shipped("std");
    BOOST_TEST(d.rows.size() == standard.rows.size() + 6);
    BOOST_TEST(standard.gravity.on_walls);
    BOOST_TEST((d.walls == scene::WallPlace::inside));
}

BOOST_AUTO_TEST_CASE(a_class_stands_for_its_rotations_and_mirror_images_once_each) {
    BOOST_TEST(read_rows("{ from = \"i i+3\", to = \"i+1 i+4\", probability = 0.5 }").rows.size() ==
               6U);
    BOOST_TEST(read_rows("{ from = \"i i+3\", to = \"R R\" }").rows.size() == 3U);
    BOOST_TEST(read_rows("{ from = \"i i+2\", to = \"i+1 R\" }").rows.size() == 6U);
    BOOST_TEST(read_rows("{ from = \"i i+3\", to = \"i+1 i+4\", mirror = false }").rows.size() ==
               3U);
    BOOST_TEST(read_rows("{ from = \"0 3\", to = \"1 4\" }").rows.size() == 1U);
    BOOST_TEST(read_rows("{ from = \"0 3\", to = \"1 4\" }").rows.front().line == 4);
}

BOOST_AUTO_TEST_CASE(a_row_that_breaks_a_conservation_law_is_refused) {
    check_row("{ from = \"i i+3\", to = \"R\" }", "collision.to", 4, "does not conserve mass");
    check_row("{ from = \"i i+3\", to = \"R R\" },\n{ from = \"0 2\", to = \"R R\" }",
              "collision.to", 5, "does not conserve momentum");
    check_row("{ from = \"i i+1\", to = \"i+1 R\" }", "collision.to", 4,
              "does not conserve momentum");
    const auto e = row_refusal("{ from = \"0 3\", to = \"1 2\" }");
    BOOST_TEST(e.got == "(0, 0) in '0 3' -> (2, 0) in '1 2'");
}

BOOST_AUTO_TEST_CASE(more_than_one_rest_particle_before_is_refused) {
    check_row("{ from = \"0 3 R R\", to = \"R R R R\" }", "collision.from", 4,
              "has too many particles at rest");
}

BOOST_AUTO_TEST_CASE(probabilities_outside_the_unit_interval_are_refused) {
    const auto with = [](const std::string& probability) {
        return "{ from = \"0 3\", to = \"1 4\", probability = " + probability + " }";
    };
    for (const char* bad : {"1.5", "-0.1", "\"2*p\"", "\"1+p\"", "\"p-1\""}) {
        check_row(with(bad), "collision.probability", 4, "is out of range");
    }
    for (const char* bad :
         {"\"q\"", "\"p*p\"", "\"1/p\"", "\"(1-p\"", "\"1-p)/2\"", "\"\"", "\"p/0\"", "\"p p\""}) {
        check_row(with(bad), "collision.probability", 4, "is not an expression");
    }
    for (const char* good : {"\"p\"", "\"1-p\"", "\" ( 1 - p ) / 2\"", "\"p/3\"",
                             "\".5 * p + 0.5\"", "\"(1-p)*(1/4)\"", "0", "1"}) {
        BOOST_CHECK_NO_THROW((void)read_rows(with(good)));
    }
    BOOST_TEST(read_rows(with("\".5 * p + 0.25\"")).rows[0].probability.at(0.5) == 0.5);
}

BOOST_AUTO_TEST_CASE(probabilities_of_a_configuration_must_not_add_up_to_more_than_one) {
    const std::string rotated = "{ from = \"i i+3\", to = \"i+1 i+4\", probability = \"(1-p)/2\" }";
    // Both images of the rotation count.
    check_row("{ from = \"i i+3\", to = \"i+1 i+4\", probability = \"1-p\" }",
              "collision.probability", 4, "adds up to more than 1");
    check_row(rotated + ",\n{ from = \"0 3\", to = \"R R\", probability = 0.5 }",
              "collision.probability", 5, "adds up to more than 1");
    BOOST_CHECK_NO_THROW(
        (void)read_rows(rotated + ",\n{ from = \"0 3\", to = \"R R\", probability = \"p\" }"));
}

BOOST_AUTO_TEST_CASE(rows_that_say_nothing_or_say_it_twice_are_refused) {
    check_row("{ from = \"0 3\", to = \"3 0\" }", "collision.to", 4, "changes nothing");
    check_row("{ from = \"i i+3\", to = \"R R\", probability = 0.1 },\n"
              "{ from = \"0 3\", to = \"R R\", probability = 0.1 }",
              "collision.to", 5, "is given twice");
    check_row("{ from = \"0 3\", to = \"R R\", probability = 0.1 },\n"
              "{ from = \"0 3\", to = \"1 4\", probability = 0.1, spectators = true }",
              "collision.spectators", 5, "contradicts");
    check_row("{ from = \"i i+3\", to = \"1 4\" }", "collision.to", 4, "contradicts");
    check_row("{ from = \"i 3\", to = \"R R\" }", "collision.from", 4, "is not a configuration");
    check_row("{ from = \"i i+6\", to = \"R R\" }", "collision.from", 4, "is not a configuration");
    check_row("{ from = \"0 0\", to = \"R R\" }", "collision.from", 4, "holds a direction twice");
    check_row("{ from = \"0 3\", to = \"R R\", chance = 1 }", "collision.chance", 4,
              "is not a known key");
    check_row("", "collision", 3, "has the wrong type");
}

BOOST_AUTO_TEST_CASE(everything_beside_the_table_must_be_said) {
    const std::string good = tests::reading_with("{ from = \"0 3\", to = \"R R\" }");
    const auto check = [&](const std::string& what, const std::string& by, const std::string& key,
                           const std::string& problem) {
        const tests::TextFile file(tests::replaced(good, what, by));
        const auto e = tests::refusal([&] { (void)scene::load_gas_reading(file.path()); });
        BOOST_TEST(e.key == key);
        BOOST_TEST(e.problem == problem);
    };
    check("outside", "beside", "walls", "is not known");
    check("origin-first", "origin-last", "relocation", "is not known");
    check("up_diagonals = true\n", "", "gravity.up_diagonals", "is missing");
    check("on_walls = false\n", "on_walls = 0\n", "gravity.on_walls", "has the wrong type");
    check("[gravity]", "extra = 1\n[gravity]", "extra", "is not a known key");
}
