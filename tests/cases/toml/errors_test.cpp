// Whatever is wrong with an input file is refused with the file, the line, the column, the key,
// what was found, what was expected and the nearest valid key.
#include "cases/toml/toml_table.hpp"
#include "tests/cases/toml/refusal.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <fstream>
#include <string>

using namespace crossgrain;
using tests::refusal;
using toml_input::Range;
using toml_input::TomlTable;

namespace {

// Lines are counted from the first one after the quote.
const toml::table input = toml::parse(R"(title = "three"
size = -3.5
count = 2.5
  few = 1
list = [1.0, -2.0,
        "three"]
words = ["a", 4]
empty = []
huge = inf
none = nan
[part]
  colour = "rde"
  flag = "yes"
[[entry]]
name = "first"
[[entry]]
nmae = "second"
)");

const TomlTable table("case.toml", "", {&input});

/// Holds place and words of a refusal against what is expected; an empty word asks nothing.
void check(const CaseErrorDetails& e, int line, int column, const std::string& key,
           const std::string& problem, const std::string& got, const std::string& expected) {
    BOOST_TEST_CONTEXT("refusal of '" << key << "'") {
        BOOST_TEST(e.file == "case.toml");
        BOOST_TEST(e.line == line);
        BOOST_TEST(e.column == column);
        BOOST_TEST(e.key == key);
        BOOST_TEST(e.problem == problem);
        BOOST_TEST(e.got == got);
        BOOST_TEST(e.expected == expected);
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_number_out_of_range_is_refused_where_it_stands) {
    check(refusal([] { (void)table.number("size", Range::positive()); }), 2, 8, "size",
          "is out of range", "-3.5", "a number > 0");
    check(refusal([] { (void)table.optional_number("size", Range::at_least(2)); }), 2, 8, "size",
          "is out of range", "-3.5", "a number >= 2");
    check(refusal([] { (void)table.number("few", Range::left_open(1, 3)); }), 4, 9, "few",
          "is out of range", "1", "a number in (1, 3]");
    check(refusal([] { (void)table.integer("few", 2); }), 4, 9, "few", "is out of range", "1",
          "an integer >= 2");
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none_are_refused) {
    check(refusal([] { (void)table.number("huge", Range::any()); }), 9, 8, "huge",
          "is out of range", "inf", "a finite number");
    check(refusal([] { (void)table.number("none", Range::any()); }), 10, 8, "none",
          "is out of range", "nan", "a finite number");
}

BOOST_AUTO_TEST_CASE(a_wrong_type_is_refused_where_it_stands) {
    const auto wrong = [](int line, int column, const std::string& key, const std::string& got,
                          const std::string& expected, auto read) {
        check(refusal(read), line, column, key, "has the wrong type", got, expected);
    };
    wrong(1, 9, "title", "'three'", "a number > 0",
          [] { (void)table.number("title", Range::positive()); });
    wrong(5, 8, "list", "an array", "a finite number",
          [] { (void)table.number("list", Range::any()); });
    wrong(3, 9, "count", "2.5", "an integer >= 1", [] { (void)table.integer("count", 1); });
    wrong(2, 8, "size", "-3.5", "a string", [] { (void)table.text("size"); });
    wrong(1, 9, "title", "'three'", "an array of strings", [] { (void)table.texts("title"); });
    wrong(13, 10, "part.flag", "'yes'", "true or false",
          [] { (void)table.table("part").boolean("flag"); });
    wrong(2, 8, "size", "-3.5", "a table", [] { (void)table.table("size"); });
    wrong(2, 8, "size", "-3.5", "[[size]] tables", [] { (void)table.tables("size"); });
    wrong(5, 8, "list", "an array", "[[list]] tables", [] { (void)table.tables("list"); });
}

BOOST_AUTO_TEST_CASE(an_element_of_an_array_is_refused_where_it_stands) {
    check(refusal([] { (void)table.numbers("list", Range::positive()); }), 5, 14, "list",
          "is out of range", "-2.0", "a number > 0");
    check(refusal([] { (void)table.numbers("list", Range::any()); }), 6, 9, "list",
          "has the wrong type", "'three'", "a finite number");
    check(refusal([] { (void)table.numbers("empty", Range::any()); }), 8, 9, "empty", "is empty",
          "[]", "at least one number");
}

BOOST_AUTO_TEST_CASE(an_element_of_a_list_of_words_is_refused_where_it_stands) {
    check(refusal([] { (void)table.texts("words"); }), 7, 15, "words", "has the wrong type", "4",
          "a string");
}

BOOST_AUTO_TEST_CASE(a_missing_key_is_refused_at_its_table) {
    check(refusal([] { (void)table.table("part").number("width", Range::positive()); }), 11, 1,
          "part.width", "is missing", "", "a number > 0");
    // The entry has 'nmae': what was meant is said instead of what is missing.
    const auto misspelt = refusal([] { (void)table.tables("entry").at(1).text("name"); });
    check(misspelt, 17, 1, "entry.nmae", "is not a known key", "", "");
    BOOST_TEST(misspelt.hint == "did you mean 'name'?");
    for (const auto& details :
         {refusal([] { (void)table.integer("absent", 1); }),
          refusal([] { (void)table.text("absent"); }), refusal([] { (void)table.texts("absent"); }),
          refusal([] { (void)table.boolean("absent"); }),
          refusal([] { (void)table.numbers("absent", Range::any()); })}) {
        BOOST_TEST(details.problem == "is missing");
        BOOST_TEST(details.key == "absent");
        BOOST_TEST(details.file == "case.toml");
    }
}

BOOST_AUTO_TEST_CASE(an_unknown_word_is_refused_with_the_choice_and_the_nearest_one) {
    const std::array<std::string, 3> colours{"green", "red", "blue"};
    const auto e = refusal([&] { (void)table.table("part").choice("colour", colours); });
    check(e, 12, 12, "part.colour", "is not known", "\"rde\"", R"(one of "green", "red", "blue")");
    BOOST_TEST(e.hint == "did you mean \"red\"?");
}

BOOST_AUTO_TEST_CASE(an_unknown_key_is_refused_where_it_stands_with_the_nearest_key) {
    const auto entry = table.tables("entry").at(1);
    (void)entry.has("name");
    (void)entry.has("codes");
    const auto e = refusal([&] { entry.reject_unknown_keys(); });
    check(e, 17, 1, "entry.nmae", "is not a known key", "", "one of name, codes");
    BOOST_TEST(e.hint == "did you mean 'name'?");
}

BOOST_AUTO_TEST_CASE(an_unknown_key_far_from_all_others_gets_no_hint) {
    const auto part = table.table("part");
    (void)part.has("colour");
    const auto e = refusal([&] { part.reject_unknown_keys(); });
    check(e, 13, 3, "part.flag", "is not a known key", "", "one of colour");
    BOOST_TEST(e.hint.empty());
}

BOOST_AUTO_TEST_CASE(an_unknown_key_in_any_layer_is_refused) {
    const toml::table upper = toml::parse("colour = \"red\"\n colur = 1");
    const auto* lower = input["part"].as_table();
    for (const auto& layers : {std::vector<const toml::table*>{&upper, lower}, {lower, &upper}}) {
        const TomlTable t("case.toml", "part", layers);
        (void)t.has("colour");
        (void)t.has("flag");
        const auto e = refusal([&] { t.reject_unknown_keys(); });
        BOOST_TEST(e.key == "part.colur");
        BOOST_TEST(e.line == 2);
        BOOST_TEST(e.column == 2);
    }
}

BOOST_AUTO_TEST_CASE(a_key_that_was_asked_for_is_known_in_every_layer) {
    const toml::table upper = toml::parse("colour = \"red\"\nflag = true");
    const TomlTable t("case.toml", "part", {&upper, input["part"].as_table()});
    (void)t.text("colour");
    (void)t.boolean("flag");
    BOOST_CHECK_NO_THROW(t.reject_unknown_keys());
}

BOOST_AUTO_TEST_CASE(a_file_that_is_not_toml_is_refused_where_it_goes_wrong) {
    const tests::TemporaryDirectory directory;
    const std::string file = (directory.path() / "bad.toml").string();
    std::ofstream(file) << "a = 1\nb = \n";
    const auto e = refusal([&] { (void)toml_input::parse_toml_file(file); });
    BOOST_TEST(e.file == file);
    BOOST_TEST(e.line == 2);
    BOOST_TEST(e.column > 1);
    BOOST_TEST(e.problem.starts_with("is not valid TOML: "));
}

BOOST_AUTO_TEST_CASE(a_key_that_is_given_twice_is_not_toml) {
    const tests::TemporaryDirectory directory;
    const std::string file = (directory.path() / "twice.toml").string();
    std::ofstream(file) << "a = 1\na = 2\n";
    BOOST_TEST(refusal([&] { (void)toml_input::parse_toml_file(file); }).line == 2);
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_refused_by_its_name) {
    const tests::TemporaryDirectory directory;
    for (const auto& path : {directory.path() / "missing.toml", directory.path()}) {
        const auto e = refusal([&] { (void)toml_input::parse_toml_file(path.string()); });
        BOOST_TEST(e.file == path.string());
        BOOST_TEST(e.problem == "cannot be read");
        BOOST_TEST(e.line == 0);
    }
}

BOOST_AUTO_TEST_CASE(a_good_file_is_read) {
    const tests::TemporaryDirectory directory;
    const std::string file = (directory.path() / "good.toml").string();
    std::ofstream(file) << "a = 1\n";
    const toml::table root = toml_input::parse_toml_file(file);
    BOOST_TEST(TomlTable(file, "", {&root}).integer("a", 0) == 1);
}
