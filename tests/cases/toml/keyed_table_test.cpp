// Protects reading by declarations: what is not declared cannot be read, and what is declared is
// held to its type, its range, its words and its group.
#include "cases/toml/keyed_table.hpp"
#include "tests/cases/toml/refusal.hpp"

#include <boost/test/unit_test.hpp>

#include <stdexcept>
#include <string>

using namespace crossgrain;
using namespace crossgrain::toml_input;
using tests::refusal;

namespace {

const TableKeys& disc_keys() {
    static const TableKeys keys{.name = "disc",
                                .keys = {{"radius", NumberRule{Range::positive()}, "of a disc"}}};
    return keys;
}

const TableKeys& keys() {
    static const Kinds kinds{.key = "kind", .of = {{"disc", disc_keys}}};
    static const TableKeys all{
        .name = "test",
        .keys = {{"kind", ChoiceRule{kinds.words()}, "of shape"},
                 {"size", NumberRule{Range::positive()}, "a size"},
                 {"ends", NumbersRule{Range::any(), 2}, "first and last"},
                 {"count", IntegerRule{2, 5}, "a count"},
                 {"reason", TextRule{.may_be_empty = false}, "why"},
                 {"fields", TextsRule{{"mass", "momentum"}}, "what is kept"},
                 {"form", {ChoiceRule{{"round"}}, TableRule{disc_keys}}, "a word or a table"},
                 {"step", NumberRule{Range::positive()}, "either"},
                 {"steps", NumberRule{Range::positive()}, "or"}},
        .groups = {OneOf{{"step", "steps"}}},
        .kinds = kinds};
    return all;
}

/// Of the text, which lives as long as the test.
KeyedTable read(const std::string& text) {
    static toml::table root;
    root = toml::parse(text);
    return {TomlTable("test.toml", "", {&root}), keys()};
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_not_declared_cannot_be_read) {
    const auto t = read("weight = 1.0\nsize = 2.0\nradius = 1.0");
    BOOST_CHECK_THROW((void)t.has("weight"), std::logic_error);
    BOOST_CHECK_THROW((void)t.number("weight"), std::logic_error);
    BOOST_CHECK_THROW((void)t.table("weight"), std::logic_error);
    BOOST_CHECK_THROW((void)t.boolean("size"), std::logic_error);
    BOOST_CHECK_THROW((void)t.number("count"), std::logic_error);
    BOOST_CHECK_THROW((void)t.exactly_one("size"), std::logic_error);
    BOOST_CHECK_THROW((void)t.number("radius"), std::logic_error);  // of another kind
    BOOST_TEST(read("kind = \"disc\"\nradius = 1.0").number("radius") == 1.0);
}

BOOST_AUTO_TEST_CASE(values_are_held_to_what_is_declared) {
    const auto problem = [](const std::string& text, auto&& ask) {
        return refusal([&] { (void)ask(read(text)); }).problem;
    };
    const auto number = [](const KeyedTable& t) { return t.number("size"); };
    BOOST_TEST(problem("size = 0", number) == "is out of range");
    BOOST_TEST(problem("size = \"1\"", number) == "has the wrong type");
    BOOST_TEST(problem("", number) == "is missing");
    const auto numbers = [](const KeyedTable& t) { return t.numbers("ends"); };
    BOOST_TEST(problem("ends = [1, 2, 3]", numbers) == "has the wrong length");
    BOOST_TEST(read("ends = 1").numbers("ends").size() == 1u);
    const auto integer = [](const KeyedTable& t) { return t.integer("count"); };
    BOOST_TEST(problem("count = 6", integer) == "is out of range");
    BOOST_TEST(read("count = 5").integer("count") == 5);
    const auto text = [](const KeyedTable& t) { return t.text("reason"); };
    BOOST_TEST(problem("reason = \"\"", text) == "is empty");
    const auto texts = [](const KeyedTable& t) { return t.texts("fields"); };
    BOOST_TEST(problem("fields = [\"mass\", \"mas\"]", texts) == "names what is not known");
    BOOST_TEST(refusal([&] { (void)texts(read("fields = [\"mas\"]")); }).hint ==
               "did you mean \"mass\"?");
}

BOOST_AUTO_TEST_CASE(a_key_may_have_one_of_several_forms) {
    BOOST_TEST(read("form = \"round\"").choice("form") == 0u);
    BOOST_TEST(read("form = { radius = 2.0 }").table("form").number("radius") == 2.0);
    BOOST_TEST(refusal([] { read("form = 1").check_table("form"); }).problem ==
               "has the wrong type");
}

BOOST_AUTO_TEST_CASE(of_a_group_exactly_one_is_given) {
    BOOST_TEST(read("steps = 1").exactly_one("step") == "steps");
    const auto ask = [](const std::string& text) {
        return refusal([&] { (void)read(text).exactly_one("steps"); });
    };
    BOOST_TEST(ask("step = 1\nsteps = 1").problem == "contradicts");
    BOOST_TEST(ask("").problem == "is missing");
    BOOST_TEST(ask("").key == "step");
}
