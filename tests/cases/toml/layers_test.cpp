// Layers of tables read as one: the upper one wins, key by key, at every depth.
//
// How to write a test here (this file is the one to copy):
// - One subject per file, <subject>_test.cpp, in the folder that mirrors the code's. Add the
// subject
//   to the CMakeLists.txt beside it; the label is `unit`, or `physics` if an engine has to run.
// - The first line of the file and the name of each test case say what is protected: a reader who
//   sees the name fail knows what is broken without opening the file.
// - Get the input by the shortest way (text in the test, a scene of tests/support/scenes.hpp);
// files
//   go to a tests::TemporaryDirectory.
// - BOOST_TEST(value == expected) prints both sides. Numbers that are not exact get a tolerance
// and,
//   as a comment, the reason for that size: `tt::tolerance(1e-12));  // 400 roundings`.
// - Also show the test's teeth: that bad input is refused, that the event looked at did happen.
#include "cases/toml/toml_table.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

using namespace crossgrain;
using toml_input::Range;
using toml_input::TomlTable;

namespace {

const toml::table top = toml::parse(R"(
    size = 2.0
    nested = { a = 10 }
    list = [1.0]
    [[entry]]
    name = "top"
)");
const toml::table bottom = toml::parse(R"(
    size = 1.0
    colour = "red"
    count = 7
    flag = true
    nested = { a = 1, b = 2, deep = { c = 3 } }
    list = [1.0, 2, 3.5]
    words = ["x", "y"]
    [[entry]]
    name = "first"
    [[entry]]
    name = "second"
)");

TomlTable layered() {
    return {"case.toml", "", {&top, &bottom}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_key_is_taken_from_the_first_layer_that_has_it) {
    BOOST_TEST(layered().number("size", Range::any()) == 2.0);
    BOOST_TEST(layered().text("colour") == "red");
    BOOST_TEST(TomlTable("", "", {&bottom, &top}).number("size", Range::any()) == 1.0);
}

BOOST_AUTO_TEST_CASE(sub_tables_merge_key_by_key) {
    const auto nested = layered().table("nested");
    BOOST_TEST(nested.integer("a", 0) == 10);
    BOOST_TEST(nested.integer("b", 0) == 2);
    BOOST_TEST(nested.table("deep").integer("c", 0) == 3);
    BOOST_TEST(nested.dotted("a") == "nested.a");
    BOOST_TEST(nested.table("deep").dotted("c") == "nested.deep.c");
}

BOOST_AUTO_TEST_CASE(arrays_are_replaced_as_a_whole) {
    BOOST_TEST(layered().numbers("list", Range::any()).size() == 1u);
    const auto entries = layered().tables("entry");
    BOOST_TEST_REQUIRE(entries.size() == 1u);
    BOOST_TEST(entries[0].text("name") == "top");
}

BOOST_AUTO_TEST_CASE(an_absent_table_reads_as_empty) {
    const auto absent = layered().table("absent");
    BOOST_TEST(!absent.has("a"));
    BOOST_TEST(absent.keys().empty());
    BOOST_TEST(layered().tables("absent").empty());
    BOOST_CHECK_NO_THROW(absent.reject_unknown_keys());
}

BOOST_AUTO_TEST_CASE(keys_of_all_layers_are_known_once_each) {
    auto keys = layered().keys();
    std::sort(keys.begin(), keys.end());
    const std::vector<std::string> expected{"colour", "count",  "entry", "flag",
                                            "list",   "nested", "size",  "words"};
    BOOST_TEST(keys == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(every_type_reads_back_what_is_written) {
    const TomlTable t("case.toml", "", {&bottom});
    BOOST_TEST(t.number("count", Range::any()) == 7.0);  // an integer is a number
    BOOST_TEST(t.integer("count", 7) == 7);
    BOOST_TEST(t.boolean("flag"));
    const std::vector<double> list{1.0, 2.0, 3.5};
    BOOST_TEST(t.numbers("list", Range::any()) == list, boost::test_tools::per_element());
    BOOST_TEST(t.numbers("size", Range::any()).at(0) == 1.0);  // one number is a list of one
    BOOST_TEST(t.texts("words").at(1) == "y");
    BOOST_TEST(t.is_text("colour"));
    BOOST_TEST(!t.is_text("count"));
    BOOST_TEST(!t.is_text("absent"));
    const std::array<std::string, 2> colours{"green", "red"};
    BOOST_TEST(t.choice("colour", colours) == 1u);
}

BOOST_AUTO_TEST_CASE(optional_keys_may_be_absent) {
    BOOST_TEST(!layered().optional_number("absent", Range::any()).has_value());
    BOOST_TEST(!layered().optional_text("absent").has_value());
    BOOST_TEST(layered().optional_number("size", Range::any()).value() == 2.0);
    BOOST_TEST(layered().optional_text("colour").value() == "red");
}

BOOST_AUTO_TEST_CASE(ranges_hold_their_ends_as_they_say) {
    BOOST_TEST(!Range::positive().holds(0));
    BOOST_TEST(Range::positive().holds(5e-324));
    BOOST_TEST(Range::not_negative().holds(0));
    BOOST_TEST(!Range::not_negative().holds(-5e-324));
    BOOST_TEST(!Range::left_open(0, 1).holds(0));
    BOOST_TEST(Range::left_open(0, 1).holds(1));
    BOOST_TEST(!Range::left_open(0, 1).holds(1.0000000000000002));
    BOOST_TEST(Range::at_least(3).holds(3));
    BOOST_TEST(!Range::at_least(3).holds(2.9));
    BOOST_TEST(Range::any().holds(-1e308));
    for (const auto& range : {Range::any(), Range::positive(), Range::at_least(0)}) {
        BOOST_TEST(!range.holds(std::numeric_limits<double>::infinity()));
        BOOST_TEST(!range.holds(std::numeric_limits<double>::quiet_NaN()));
    }
}
