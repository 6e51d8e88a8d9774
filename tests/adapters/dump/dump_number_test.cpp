// Numbers of dumps: every way of writing one is read, and what is none is named for what it is.
#include "adapters/dump/dump_number.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

using namespace crossgrain;
using adapters::dump::dump_number;
using adapters::dump::why_no_integer;
using adapters::dump::why_no_number;

namespace {

double number(std::string_view word) {
    return dump_number<double>(word).value_or(std::nan(""));
}

bool is_whole(std::string_view word) {
    return dump_number<std::int64_t>(word).has_value();
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_may_have_a_plus_sign) {
    BOOST_TEST(number("+1") == 1.0);
    BOOST_TEST(number("+1.5e+3") == 1500.0);
    BOOST_TEST(number("-1") == -1.0);
    BOOST_TEST(dump_number<std::int64_t>("+7").value() == 7);
    for (const auto* word : {"+", "-", "", "++1", "+-1", "-+1", "1+"})
        BOOST_TEST(std::isnan(number(word)), word);
}

BOOST_AUTO_TEST_CASE(what_is_too_small_for_a_double_is_the_nearest) {
    BOOST_TEST(number("1e-400") == 0.0);
    BOOST_TEST(std::signbit(number("-1e-400")));
    BOOST_TEST(number("4.9e-324") == 4.9406564584124654e-324);
    BOOST_TEST(number("1e-310") == 1e-310);
    BOOST_TEST(std::isnan(number("1e400")));
    BOOST_TEST(std::isnan(number("-1e400")));
}

BOOST_AUTO_TEST_CASE(whole_numbers_are_whole_and_fit) {
    BOOST_TEST(dump_number<std::int64_t>("-9223372036854775808").has_value());
    BOOST_TEST(!is_whole("9223372036854775808"));
    BOOST_TEST(!is_whole("99999999999999999999"));
    BOOST_TEST(!is_whole("1.0"));
    BOOST_TEST(!is_whole("1e3"));
    BOOST_TEST(why_no_integer("1.0") == std::string("is not a whole number of at most 64 bits"));
    BOOST_TEST(why_no_integer("one") == std::string("is not a number"));
}

BOOST_AUTO_TEST_CASE(what_is_no_number_is_named) {
    const auto says = [](const char* word, const char* reason) {
        const std::string answer = why_no_number(word);
        BOOST_TEST(answer.find(reason) != std::string::npos, word << ": " << answer);
    };
    says("10,9", "decimal comma");
    says("1.0D+00", "Fortran's D");
    says("1.0d0", "Fortran's D");
    says("-0.80301867518e", "cut off");
    says("-", "cut off");
    says("0.5a", "is not a number");
    BOOST_TEST(why_no_number("grain") == std::string("is not a number"));
}
