// Nesting is bounded before anything recurses, whatever strings and comments look like.
#include "cases/toml/nesting.hpp"
#include "tests/cases/toml/refusal.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using toml_input::check_nesting;
using toml_input::deepest_nesting;

namespace {

std::string repeated(const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i)
        text += part;
    return text;
}

void check_refused(const std::string& text, int line) {
    const auto e = tests::refusal([&] { check_nesting(text, "deep.toml"); });
    BOOST_TEST(e.file == "deep.toml");
    BOOST_TEST(e.line == line, text.substr(0, 60));
    BOOST_TEST(e.problem.find("too deeply") != std::string::npos);
}

void check_accepted(const std::string& text) {
    BOOST_CHECK_NO_THROW(check_nesting(text, "case.toml"));
}

}  // namespace

BOOST_AUTO_TEST_CASE(keys_and_headers_have_a_limit) {
    check_accepted(repeated("a.", deepest_nesting) + "a = 1\n");
    check_refused(repeated("a.", deepest_nesting + 1) + "a = 1\n", 1);
    check_refused("x = 1\n[" + repeated("a.", 100'000) + "a]\n", 2);
    check_refused("x = 1\n\n[[" + repeated("'a'.", 100'000) + "a]]\n", 3);
    check_refused("x = { " + repeated("\"a\" . ", 100'000) + "a = 1 }\n", 1);
    check_refused(repeated("\"a\\\".\".", 100'000) + "a = 1\n", 1);
}

BOOST_AUTO_TEST_CASE(brackets_have_a_limit) {
    check_accepted("x = " + repeated("[", deepest_nesting) + repeated("]", deepest_nesting) + "\n");
    check_refused("x = " + repeated("[", 100'000), 1);
    check_refused("x = " + repeated("{ a = ", 100'000), 1);
    check_refused("x = [\n" + repeated("[\n", 100'000), deepest_nesting + 1);
}

BOOST_AUTO_TEST_CASE(what_is_no_nesting_does_not_count) {
    const std::string dots = repeated(".", 100), open = repeated("[", 100);
    check_accepted("x = \"" + dots + open + "\"\ny = '" + dots + open + "'\n");
    check_accepted("x = \"\"\"\n" + dots + "\n\"\"" + open + "\"\"\"\"\"\n");
    check_accepted("x = '''" + dots + "''" + open + "''''\n");
    check_accepted("# " + dots + open + "\nx = 1\n");
    check_accepted("x = \"\\\"" + open + "\"\n");
    check_accepted("x = [" + repeated("1.5, ", 1000) + "]\n");
    check_accepted(repeated("a.b.c = 1.5\n", 1000));
    check_accepted("");
}

BOOST_AUTO_TEST_CASE(strings_do_not_hide_what_follows_them) {
    const std::string deep = repeated("[", 100);
    check_refused("x = [\"a\", 'b', " + deep, 1);
    check_refused("x = [\"\"\"a\"\"\"\"\", " + deep, 1);
    check_refused("x = ['''a''''', " + deep, 1);
    check_refused("x = \"not closed\ny = " + deep, 2);
    check_refused("x = 'not closed \\\ny = " + deep, 2);
    check_refused("x = \"\\\\\"\ny = " + deep, 2);
}
