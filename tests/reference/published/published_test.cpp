// Published numbers are found by their id with all that is known about them; a file that leaves
// something out is refused.
#include "reference/published/published.hpp"

#include "native/base/errors.hpp"
#include "tests/cases/toml/refusal.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <string>

using namespace crossgrain;
using published::PublishedValues;

namespace {

const std::string good = R"toml(source = "Author, Journal 1, 2 (1995)"
[value.slope]
quantity = "slope of something"
value = -1.5
error = 0.1
place = "Fig. 3"
obtained = "read from the figure"
[value.other]
quantity = "another"
value = 2
error = 0.0
place = "p. 7"
obtained = "text"
)toml";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

CaseErrorDetails refusal_with(const std::string& what, const std::string& by) {
    const tests::TemporaryDirectory directory;
    write(directory.path() / "author-1995.toml", replaced(good, what, by));
    const auto e = tests::refusal([&] { PublishedValues values(directory.path()); });
    BOOST_TEST(e.file == (directory.path() / "author-1995.toml").string());
    return e;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_trend_stands_in_place_of_a_value) {
    const tests::TemporaryDirectory directory;
    write(directory.path() / "author-1995.toml",
          replaced(good, "value = -1.5\nerror = 0.1\n", "trend = \"increasing\"\n"));
    const PublishedValues values(directory.path());
    BOOST_TEST(values.find("author-1995/slope").value().trend == "increasing");
    BOOST_TEST(values.find("author-1995/other").value().trend.empty());
    BOOST_TEST(refusal_with("value = -1.5\nerror = 0.1\n", "trend = \"wavy\"\n").key ==
               "value.slope.trend");
    // Either a number or a trend.
    BOOST_TEST(refusal_with("error = 0.1\n", "error = 0.1\ntrend = \"constant\"\n").key ==
               "value.slope.error");
}

BOOST_AUTO_TEST_CASE(the_shipped_files_load_and_say_all_about_each_value) {
    const PublishedValues values(CROSSGRAIN_SOURCE_DIR "/reference/published");
    BOOST_TEST(values.size() >= 2u);
    for (const std::string id :
         {"taguchi-1995/slope-low-layers", "taguchi-1995/tail-near-surface"}) {
        const auto value = values.find(id);
        BOOST_TEST_REQUIRE(value.has_value());
        BOOST_TEST(value->id == id);
        BOOST_TEST(!value->quantity.empty());
        BOOST_TEST(!value->source.empty());
        BOOST_TEST(!value->place.empty());
        BOOST_TEST(!value->obtained.empty());
        BOOST_TEST(value->error >= 0);
    }
    // The text of section 2.3: "very close to -5/3".
    BOOST_TEST(values.find("taguchi-1995/slope-low-layers")->value == -5.0 / 3);
    BOOST_TEST(values.find("taguchi-1995/tail-near-surface")->value == 0.0);
}

BOOST_AUTO_TEST_CASE(a_value_arrives_as_it_is_written) {
    const tests::TemporaryDirectory directory;
    write(directory.path() / "author-1995.toml", good);
    const PublishedValues values(directory.path());
    BOOST_TEST(values.size() == 2u);
    const auto value = values.find("author-1995/slope");
    BOOST_TEST_REQUIRE(value.has_value());
    BOOST_TEST(value->quantity == "slope of something");
    BOOST_TEST(value->value == -1.5);
    BOOST_TEST(value->error == 0.1);
    BOOST_TEST(value->source == "Author, Journal 1, 2 (1995)");
    BOOST_TEST(value->place == "Fig. 3");
    BOOST_TEST(value->obtained == "read from the figure");
}

BOOST_AUTO_TEST_CASE(an_unknown_id_is_nothing) {
    const PublishedValues values(CROSSGRAIN_SOURCE_DIR "/reference/published");
    for (const std::string id : {"", "slope-low-layers", "taguchi-1995", "taguchi-1995/",
                                 "taguchi-1995/slope", "Taguchi-1995/slope-low-layers"}) {
        BOOST_TEST(!values.find(id).has_value(), id);
    }
}

BOOST_AUTO_TEST_CASE(an_empty_directory_holds_nothing) {
    const tests::TemporaryDirectory directory;
    BOOST_TEST(PublishedValues(directory.path()).size() == 0u);
    write(directory.path() / "notes.txt", "not TOML");
    BOOST_TEST(PublishedValues(directory.path()).size() == 0u);
}

BOOST_AUTO_TEST_CASE(values_of_several_files_stay_apart) {
    const tests::TemporaryDirectory directory;
    write(directory.path() / "a.toml", good);
    write(directory.path() / "b.toml", replaced(good, "-1.5", "-2.5"));
    const PublishedValues values(directory.path());
    BOOST_TEST(values.size() == 4u);
    BOOST_TEST(values.find("a/slope")->value == -1.5);
    BOOST_TEST(values.find("b/slope")->value == -2.5);
}

BOOST_AUTO_TEST_CASE(a_value_that_leaves_something_out_is_refused) {
    for (const std::string line :
         {"quantity = \"slope of something\"", "value = -1.5", "error = 0.1", "place = \"Fig. 3\"",
          "obtained = \"read from the figure\""}) {
        const auto e = refusal_with(line, "");
        BOOST_TEST(e.key == "value.slope." + line.substr(0, line.find(' ')));
        BOOST_TEST(e.problem == "is missing");
        BOOST_TEST(e.line == 2);
    }
    BOOST_TEST(refusal_with("source = ", "#").key == "source");
}

BOOST_AUTO_TEST_CASE(a_value_with_something_wrong_is_refused_where_it_stands) {
    auto e = refusal_with("error = 0.1", "error = -0.1");
    BOOST_TEST(e.problem == "is out of range");
    BOOST_TEST(e.line == 5);
    e = refusal_with("value = -1.5", "value = \"-3/2\"");
    BOOST_TEST(e.problem == "has the wrong type");
    BOOST_TEST(e.line == 4);
    e = refusal_with("place", "page = 3\nplace");
    BOOST_TEST(e.key == "value.slope.page");
    BOOST_TEST(e.hint == "did you mean 'place'?");
    e = refusal_with("[value.other]", "[valeu.other]");
    BOOST_TEST(e.key == "valeu");
    BOOST_TEST(e.hint == "did you mean 'value'?");
    e = refusal_with("[value.other]", "broken =");
    BOOST_TEST(e.problem.starts_with("is not valid TOML"));
}
