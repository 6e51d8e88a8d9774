// One gate for texts: what is shown as it is passes, what could do anything else is refused with
// file, line and key.
#include "cases/toml/text_file.hpp"
#include "cases/toml/text_rules.hpp"
#include "cases/toml/toml_table.hpp"
#include "tests/cases/toml/refusal.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <fstream>
#include <string>
#include <string_view>

using namespace crossgrain;
using namespace std::string_view_literals;
using tests::refusal;
using toml_input::fault_in;
using toml_input::TextKind;
using toml_input::TomlTable;

namespace {

std::string problem(std::string_view text, TextKind kind) {
    const auto fault = fault_in(text, kind);
    return fault ? fault->problem : "accepted";
}

CaseErrorDetails refusal_of_file(std::string_view text) {
    const tests::TemporaryDirectory directory;
    const std::string file = directory.path() / "input.toml";
    std::ofstream(file, std::ios::binary) << text;
    return refusal([&] { (void)toml_input::parse_toml_file(file); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(names_are_one_line_of_bounded_length) {
    BOOST_TEST(problem("gas-parity", TextKind::name) == "accepted");
    BOOST_TEST(problem("\u00fcbung/\u03b8=30", TextKind::name) == "accepted");
    BOOST_TEST(problem(std::string(120, 'x'), TextKind::name) == "accepted");
    BOOST_TEST(problem(std::string(121, 'x'), TextKind::name) == "is too long");
    BOOST_TEST(problem("", TextKind::name) == "is empty");
    for (const auto hostile : {"..\0x"sv, "x\nshell touch pwned\n#"sv, "\x1b[2J"sv, "x\uFFFE"sv,
                               "\u202egnp"sv, "\x80"sv, "a\tb"sv, "\u0085"sv}) {
        BOOST_TEST(problem(hostile, TextKind::name) == "has characters that cannot be shown");
        BOOST_TEST(problem(hostile, TextKind::line) == "has characters that cannot be shown");
    }
}

BOOST_AUTO_TEST_CASE(prose_may_have_lines) {
    BOOST_TEST(problem("", TextKind::line) == "accepted");
    BOOST_TEST(problem(std::string(1000, 'x'), TextKind::line) == "accepted");
    BOOST_TEST(problem(std::string(1001, 'x'), TextKind::line) == "is too long");
    BOOST_TEST(problem("two\nlines\n\tand a tab\n", TextKind::prose) == "accepted");
    BOOST_TEST(problem("\n\n", TextKind::prose) == "accepted");
    BOOST_TEST(problem("a\r\n", TextKind::prose) == "has characters that cannot be shown");
    BOOST_TEST(problem("a\n\x1b[2J", TextKind::prose) == "has characters that cannot be shown");
    BOOST_TEST(problem(std::string(16'001, 'x'), TextKind::prose) == "is too long");
}

BOOST_AUTO_TEST_CASE(every_text_of_a_table_passes_the_gate) {
    const toml::table input = toml::parse(R"(text = "a\u0000b"
list = ["fine", "a\nb"]
[table]
"a\u001bb" = 1
[empty]
"" = 1
)");
    const TomlTable t("case.toml", "part", {&input});
    const auto e = refusal([&] { (void)t.text("text"); });
    BOOST_TEST(e.file == "case.toml");
    BOOST_TEST(e.line == 1);
    BOOST_TEST(e.key == "part.text");
    BOOST_TEST(e.got == "\"a\\x00b\"");
    BOOST_TEST(refusal([&] { (void)t.name("text"); }).line == 1);
    BOOST_TEST(refusal([&] { (void)t.prose("text"); }).line == 1);
    BOOST_TEST(refusal([&] { (void)t.optional_text("text"); }).line == 1);
    BOOST_TEST(refusal([&] { (void)t.texts("list"); }).line == 2);
    BOOST_TEST(refusal([&] { (void)t.table("table").keys(); }).line == 4);
    BOOST_TEST(refusal([&] { (void)t.table("empty").keys(); }).key == "part.empty");
}

BOOST_AUTO_TEST_CASE(a_table_has_not_any_number_of_names) {
    std::string text;
    for (int i = 0; i <= 10'000; ++i)
        text += "k" + std::to_string(i) + " = 1\n";
    const toml::table input = toml::parse(text);
    const TomlTable t("case.toml", "part", {&input});
    BOOST_TEST(refusal([&] { (void)t.keys(); }).problem == "has too many keys");
}

BOOST_AUTO_TEST_CASE(files_that_are_no_text_are_named_for_what_they_are) {
    BOOST_TEST(refusal_of_file("\x1f\x8b\x08").problem == "is compressed (gzip)");
    BOOST_TEST(refusal_of_file("\xff\xfe\x61\0"sv).problem == "is UTF-16 text");
    BOOST_TEST(refusal_of_file("a = 1\0"sv).problem == "is binary (byte 6 is 0)");
    const auto latin = refusal_of_file("a = 1\nb = \"\xe4\"\n");
    BOOST_TEST(latin.line == 2);
    BOOST_TEST(latin.problem.starts_with("is not valid TOML"));
    BOOST_TEST(refusal_of_file(std::string(toml_input::longest_file + 1, '#')).problem ==
               "is too long");
}
