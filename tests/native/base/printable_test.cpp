// Text from outside cannot end a line, move a cursor, break JSON or XML, or fill a terminal.
#include "native/base/printable.hpp"

#include "native/base/errors.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using namespace std::string_literals;

BOOST_AUTO_TEST_CASE(plain_text_stays) {
    for (const auto& text : {"bed-fluid/e=0.8"s, "Grüße, 粒子 \U0001F600"s, ""s, "a\\b"s}) {
        BOOST_TEST(is_printable(text));
        BOOST_TEST(printable(text) == text);
    }
}

BOOST_AUTO_TEST_CASE(control_characters_are_escaped) {
    BOOST_TEST(printable("a\nb\tc\r\x1b[31m\x7f\0z"s) == "a\\nb\\tc\\r\\x1b[31m\\x7f\\x00z");
    BOOST_TEST(printable("\u0085") == "\\x85");  // C1: next line
    BOOST_TEST(!is_printable("a\nb"));
    BOOST_TEST(!is_printable("\0"s));
}

BOOST_AUTO_TEST_CASE(characters_that_change_others_are_escaped) {
    BOOST_TEST(printable("\u202E"
                         "cba") == "\\u{202e}cba");
    BOOST_TEST(printable("\uFFFE") == "\\u{fffe}");  // not allowed in XML
    BOOST_TEST(printable("\u2028\uFEFF") == "\\u{2028}\\u{feff}");
}

BOOST_AUTO_TEST_CASE(bytes_that_are_not_utf8_are_escaped_one_by_one) {
    BOOST_TEST(printable("caf\xe9") == "caf\\xe9");                       // Latin-1
    BOOST_TEST(printable("\xc0\xaf") == "\\xc0\\xaf");                    // overlong
    BOOST_TEST(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");           // a surrogate
    BOOST_TEST(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
    BOOST_TEST(printable("\xe2\x82") == "\\xe2\\x82");                    // ends early
}

BOOST_AUTO_TEST_CASE(long_text_is_cut_and_says_so) {
    BOOST_TEST(printable(std::string(1000, 'x'), 10) == "xxxxxxxxxx... (990 bytes more)");
    BOOST_TEST(printable_lines("first\nlast\n", 5) == "(6 bytes before)...last\n");
    BOOST_TEST(printable_lines("a\n\x1b[2Jb", 100) == "a\n\\x1b[2Jb");
}

BOOST_AUTO_TEST_CASE(errors_can_always_be_shown) {
    const CaseError bad({.file = "caf\xe9.toml", .problem = "has a\nline", .got = "\x1b[2J"});
    BOOST_TEST(bad.what() == "caf\\xe9.toml: has a\\nline: got \\x1b[2J"s);
    BOOST_TEST(bad.details().file == "caf\\xe9.toml");
    const AdapterError crash({.code = "lammps", .reason = "\xff", .log_tail = "a\nb\x07"});
    BOOST_TEST(crash.what() == "lammps: \\xff"s);
    BOOST_TEST(crash.details().log_tail == "a\nb\\x07");
}
