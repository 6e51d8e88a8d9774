// Options of an estimator are set as they are given, and what is wrong with one is told with its
// place, the range and the nearest name.
#include "cases/observables/option_reading.hpp"

#include "native/base/errors.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <limits>
#include <stdexcept>

using namespace crossgrain;

namespace demo {

enum class Direction { upward, downward };
constexpr auto words(Direction /*of*/) {
    return std::array{"upward", "downward"};
}

struct Options {
    double share = 0.25;
    double spacing = 0;  // must be given
    std::int64_t rows = 3;
    int fewest = 1;
    std::optional<double> from = {};
    std::vector<double> shares = {0.1, 0.2};
    std::vector<std::int64_t> at = {};
    Direction direction = Direction::upward;
};

measure::OptionKeys option_keys(Options& o) {
    return {{"share", &o.share, Range::open(0, 1), "of bonds"},
            {"spacing", &o.spacing, Range::positive(), "h0 (l)"},
            {"rows", &o.rows, Range::whole(2, 9), "of the picture"},
            {"fewest", &o.fewest, Range::whole(1), "of grains"},
            {"from", &o.from, {}, "start (t)"},
            {"shares", &o.shares, Range::open(0, 1), "eps"},
            {"at", &o.at, Range::whole(0), "iterations"},
            {"direction", measure::WordOption(o.direction), {}, "of the crossing"}};
}

}  // namespace demo

namespace {

using Numbers = std::vector<double>;

demo::Options read(const std::string& name, catalog::Option option) {
    demo::Options options;
    option.line = 12;
    option.column = 8;
    observables::read_options("x.toml", {.name = "demo", .options = {{name, option}}},
                              demo::option_keys(options));
    return options;
}

demo::Options read(const std::string& name, Numbers numbers) {
    return read(name, catalog::Option{.numbers = std::move(numbers), .text = {}});
}

/// The error that reading this option gives; the test fails without one.
CaseErrorDetails refusal(const std::string& name, catalog::Option option) {
    try {
        (void)read(name, std::move(option));
    } catch (const CaseError& error) {
        const auto& details = error.details();
        BOOST_TEST(details.file == "x.toml");
        BOOST_TEST(details.line == 12);
        BOOST_TEST(details.column == 8);
        BOOST_TEST(details.key == "observable." + name);
        return details;
    }
    BOOST_ERROR("'" << name << "' was not refused");
    return {};
}

CaseErrorDetails refusal(const std::string& name, Numbers numbers) {
    return refusal(name, catalog::Option{.numbers = std::move(numbers), .text = {}});
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_given_is_set_and_the_rest_is_left) {
    BOOST_TEST(read("share", {0.5}).share == 0.5);
    BOOST_TEST(read("share", {0.5}).rows == 3);
    BOOST_TEST(read("rows", {9}).rows == 9);
    BOOST_TEST(read("fewest", {1e9}).fewest == 1'000'000'000);
    BOOST_TEST(read("from", {-2}).from.value() == -2);
    BOOST_TEST(!read("rows", {2}).from.has_value());
    BOOST_TEST((read("shares", {0.5}).shares == Numbers{0.5}));
    BOOST_TEST((read("at", {3, 1}).at == std::vector<std::int64_t>{3, 1}));
    const auto down = read("direction", catalog::Option{.numbers = {}, .text = "downward"});
    BOOST_TEST((down.direction == demo::Direction::downward));
}

BOOST_AUTO_TEST_CASE(a_number_out_of_range_is_refused_with_the_range) {
    BOOST_TEST(refusal("share", {1}).problem == "is out of range");
    BOOST_TEST(refusal("share", {1}).got == "1");
    BOOST_TEST(refusal("share", {1}).expected == "a number in (0, 1)");
    BOOST_TEST(refusal("rows", {10}).expected == "an integer from 2 to 9");
    BOOST_TEST(refusal("shares", {0.1, 2}).got == "2");
    BOOST_TEST(refusal("at", {-1}).problem == "is out of range");
    BOOST_TEST(refusal("fewest", {1e10}).problem == "is out of range");
    BOOST_TEST(refusal("from", {std::numeric_limits<double>::infinity()}).problem ==
               "is out of range");
}

BOOST_AUTO_TEST_CASE(a_wrong_type_is_refused) {
    BOOST_TEST(refusal("rows", {2.5}).problem == "has the wrong type");
    BOOST_TEST(refusal("at", {1, 2.5}).got == "2.5");
    BOOST_TEST(refusal("share", {0.1, 0.2}).got == "2 numbers");
    BOOST_TEST(refusal("share", catalog::Option{.numbers = {}, .text = "half"}).got == "\"half\"");
    BOOST_TEST(refusal("direction", {1}).got == "a number");
}

BOOST_AUTO_TEST_CASE(the_nearest_name_or_word_is_offered) {
    BOOST_TEST(refusal("shore", {0.5}).problem == "is not an option of 'demo'");
    BOOST_TEST(refusal("shore", {0.5}).hint == "did you mean 'share'?");
    const auto word = refusal("direction", catalog::Option{.numbers = {}, .text = "upwards"});
    BOOST_TEST(word.expected == R"(one of "upward", "downward")");
    BOOST_TEST(word.hint == R"(did you mean "upward"?)");
}

BOOST_AUTO_TEST_CASE(an_estimator_checks_its_ranges_by_the_same_declaration) {
    BOOST_CHECK_NO_THROW(measure::check_ranges(demo::Options{.spacing = 1}));
    BOOST_CHECK_THROW(measure::check_ranges(demo::Options{}), std::invalid_argument);
    BOOST_CHECK_THROW(measure::check_ranges(demo::Options{.spacing = 1, .shares = {0.1, 1.0}}),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(the_schema_has_type_range_default_and_need_of_the_declaration) {
    demo::Options options;
    const auto keys = observables::table_keys(demo::option_keys(options));
    BOOST_TEST_REQUIRE(keys.size() == 8U);
    BOOST_TEST(keys[0].text == "of bonds; default 0.25");
    BOOST_TEST(std::get<toml_input::NumberRule>(keys[0].rules.front()).range.high_open);
    BOOST_TEST((keys[0].need == toml_input::Need::optional));
    BOOST_TEST((keys[1].need == toml_input::Need::required));
    BOOST_TEST(keys[1].text == "h0 (l)");
    BOOST_TEST(std::get<toml_input::IntegerRule>(keys[2].rules.front()).most == 9);
    BOOST_TEST(keys[4].text == "start (t)");
    BOOST_TEST(keys[5].text == "eps; default 0.1, 0.2");
    BOOST_TEST(std::holds_alternative<toml_input::NumbersRule>(keys[6].rules.front()));
    BOOST_TEST(keys[7].text == "of the crossing; default \"upward\"");
    BOOST_TEST(std::get<toml_input::ChoiceRule>(keys[7].rules.front()).words.size() == 2U);
}
