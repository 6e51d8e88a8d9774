// What a case file can ask for is counted before it is made: sweeps, variants, replicas and their
// scenes; keys of a sweep each lead to a place of their own.
#include "tests/cases/catalog/case_text.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using tests::case_text;
using tests::load;
using tests::refusal;
using tests::refusal_of;
using tests::refusal_with;
using tests::replaced;

namespace {

std::string numbers(int count) {
    std::string text = "[";
    for (int i = 1; i <= count; ++i)
        text += std::to_string(i) + ", ";
    return text + "]";
}

CaseErrorDetails refusal_of_sweep(const std::string& sweep) {
    return refusal_of(case_text + "[sweep]\n" + sweep);
}

}  // namespace

BOOST_AUTO_TEST_CASE(combinations_are_counted_before_they_are_made) {
    const std::string axis = numbers(200);
    const auto e = refusal_of_sweep("gravity = " + axis + "\ndrag = " + axis + "\ngamma = " + axis +
                                    "\nskin = " + axis + "\nperiodic_x = " + axis);
    BOOST_TEST(e.key == "sweep");
    BOOST_TEST(e.line > 0);
    BOOST_TEST(e.got == "3.2e+11");
    BOOST_TEST(e.expected == "at most 100000 runs in a case");
    BOOST_TEST(refusal_of_sweep("gravity = " + numbers(100'001)).problem == "lists 100001 values");
}

BOOST_AUTO_TEST_CASE(a_key_and_a_key_inside_it_cannot_both_be_swept) {
    for (const auto* sweep : {"a = [1.0]\n\"a.b\" = [1.0]\n", "\"a.b\" = [1.0]\na = [1.0]\n"}) {
        const auto e = refusal_of_sweep(sweep);
        BOOST_TEST(e.key == "sweep.a.b");
        BOOST_TEST(e.problem == "lies in 'a', which is swept as well");
    }
    BOOST_TEST(refusal_of_sweep("a.b.c = [1]\n\"a.b\" = [1.0]\n").key == "sweep.a.b.c");
    BOOST_TEST(refusal_of_sweep("a.b = [1]\n\"a.b\" = [1.0]\n").problem == "is swept twice");
    BOOST_CHECK_NO_THROW(load(case_text + "[sweep]\ncontact.restitution = [0.8, 0.9]\n"
                                          "grains.mass = [1.0]\n"));
}

BOOST_AUTO_TEST_CASE(keys_of_a_sweep_have_no_empty_part) {
    for (const auto* key : {"\"\"", "\".\"", "\"a.\"", "\".a\"", "\"a..b\"", "a.\"\""}) {
        const auto e = refusal_of_sweep(std::string(key) + " = [1.0]\n");
        BOOST_TEST(e.problem.find("empty") != std::string::npos, key);
    }
    BOOST_TEST(refusal_of_sweep("\"a\\nb\" = [1.0]\n").problem ==
               "has a key that has characters that cannot be shown");
    BOOST_TEST(refusal_of_sweep("integrator = [\"a\\u0000b\"]\n").problem.find("cannot be shown") !=
               std::string::npos);
    BOOST_TEST(refusal_of_sweep("integrator = [[1.0]]\n").key == "sweep.integrator");
}

BOOST_AUTO_TEST_CASE(variants_are_told_apart_by_their_names) {
    const std::string plain = "[[variant]]\nname = \"b/c\"\n[[variant]]\nname = \"c\"\n";
    const auto e = refusal_of(case_text + plain + "[sweep]\nintegrator = [\"a\", \"a/b\"]\n");
    BOOST_TEST(e.problem == "has a name twice");
    BOOST_TEST(e.got == "'a/b/c'");
}

BOOST_AUTO_TEST_CASE(names_pass_the_gate) {
    for (const auto* from :
         {"name = \"small\"", "title = \"A small case\"", "source = \"Author, section 1\"",
          "text = \"What it asks.\"", "name = \"momentum\"", "reason = \"round-off\""}) {
        const std::string key = std::string(from).substr(0, std::string(from).find(' '));
        const auto e = refusal_with(from, key + " = \"a\\u001b[2J\"");
        BOOST_TEST(e.problem == "has characters that cannot be shown", from);
        BOOST_TEST(e.line > 0);
    }
    BOOST_TEST(refusal_with("name = \"small\"", "name = \"\"").problem == "is empty");
    BOOST_TEST(refusal_of(case_text + "[[variant]]\nname = \"x\\nshell touch pwned\\n#\"\n").key ==
               "variant.name");
    BOOST_TEST(load(replaced(case_text, "\"small\"", "\"\u00fcbung\"")).name == "\u00fcbung");
    BOOST_TEST(load(replaced(case_text, "\"What it asks.\"", "\"two\\nlines\"")).text ==
               "two\nlines");
}

BOOST_AUTO_TEST_CASE(replicas_are_counted_without_overflow) {
    const std::string usual = "replicas = { default = 2, lammps = 3 }";
    BOOST_TEST(refusal_with(usual, "replicas = { default = 4611686018427387904 }").key ==
               "replicas.default");
    const auto e = refusal_with(usual, "replicas = { default = 100000 }\n"
                                       "replicas_in = { \"*\" = 100000, \"**\" = 100000 }");
    BOOST_TEST(e.key == "replicas");
    BOOST_TEST(e.problem == "makes too many runs");
    BOOST_CHECK_NO_THROW(load(replaced(case_text, usual, "replicas = { default = 100000 }")));
    const auto c = load(case_text);
    BOOST_CHECK_NO_THROW(catalog::check_runs(c, 100'000));
    BOOST_TEST(refusal([&] { catalog::check_runs(c, 100'001); }).key == "--replicas");
}

BOOST_AUTO_TEST_CASE(scenes_that_do_not_fit_together_are_refused) {
    auto c = load(case_text);
    BOOST_TEST(c.variants.front().bytes > 16 * 32.0);
    c.variants.front().bytes = 0x1p30;
    const auto e = refusal([&] { catalog::check_runs(c, 100'000); });
    BOOST_TEST(e.problem == "makes runs that do not fit into memory");
    BOOST_TEST(e.got == "97.7 TiB of initial states");
}

BOOST_AUTO_TEST_CASE(ladders_of_time_steps_count_as_runs) {
    const auto e = refusal_with("dt = 1e-3", "dt = " + numbers(60'000));
    BOOST_TEST(e.problem == "makes too many runs");
}
