#include <boost/test/unit_test.hpp>

#include "reports/documents/junit.hpp"
#include "tests/support/well_formed_xml.hpp"

using crossgrain::reports::junit_xml;
using nlohmann::json;

namespace {

json document_of(json verdict) {
    verdict.update({{"code", "lammps"}, {"observable", "restitution"}, {"kind", "exact"}});
    return {{"cases", {{{"case", "collision"}, {"verdicts", {verdict}}}}}};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// What became of one verdict: "passed", "failure", "error" or "skipped".
std::string result_of(const json& verdict) {
    const std::string xml = junit_xml(document_of(verdict));
    BOOST_TEST_REQUIRE(contains(xml, "tests=\"1\""));
    for (const std::string result : {"failure", "error", "skipped"}) {
        if (!contains(xml, "<" + result + " ")) continue;
        const std::string plural = result == "skipped" ? "skipped" : result + "s";
        BOOST_TEST(contains(xml, plural + "=\"1\""));
        return result;
    }
    BOOST_TEST(contains(xml, "failures=\"0\" errors=\"0\" skipped=\"0\""));
    return "passed";
}

}  // namespace

BOOST_AUTO_TEST_SUITE(junit)

BOOST_AUTO_TEST_CASE(outcomes_as_expected) {
    BOOST_TEST(result_of({{"verdict", "agree"}, {"expected", true}}) == "passed");
    BOOST_TEST(result_of({{"verdict", "disagree"}, {"expected", true}}) == "passed");
    BOOST_TEST(result_of({{"verdict", "undecided"}, {"expected", true}}) == "skipped");
    BOOST_TEST(result_of({{"verdict", "no_reference"}, {"expected", true}}) == "skipped");
    BOOST_TEST(result_of({{"verdict", "not_installed"}, {"expected", true}}) == "skipped");
    BOOST_TEST(result_of({{"verdict", "not_expressible"}, {"expected", true}}) == "skipped");
    BOOST_TEST(result_of({{"verdict", "run_failed"}, {"expected", true}}) == "error");
}

BOOST_AUTO_TEST_CASE(whatever_is_unexpected_fails) {
    for (const char* outcome :
         {"agree", "disagree", "undecided", "no_reference", "not_installed", "not_expressible"})
        BOOST_TEST(result_of({{"verdict", outcome}, {"expected", false}}) == "failure");
    BOOST_TEST(result_of({{"verdict", "run_failed"}, {"expected", false}}) == "error");
}

BOOST_AUTO_TEST_CASE(a_disagreement_cannot_become_a_pass_by_omission) {
    BOOST_TEST(result_of({{"verdict", "disagree"}}) == "failure");
    BOOST_TEST(result_of({{"verdict", "disagree"}, {"expected", nullptr}}) == "failure");
    BOOST_TEST(result_of({{"verdict", "disagree"}, {"expected", "yes"}}) == "failure");
    BOOST_TEST(result_of({{"verdict", "undecided"}}) == "failure");
    BOOST_TEST(result_of({{"verdict", "Disagree"}, {"expected", true}}) == "error");
    BOOST_TEST(result_of({{"verdict", ""}, {"expected", true}}) == "error");
    BOOST_TEST(result_of({{"expected", true}}) == "error");
    BOOST_TEST(result_of({{"verdict", "agree"}}) == "passed");
}

BOOST_AUTO_TEST_CASE(an_expected_disagreement_says_why) {
    const std::string xml = junit_xml(document_of(
        {{"verdict", "disagree"}, {"expected", true}, {"reason", "first order in dt"}}));
    BOOST_TEST(contains(xml, "<system-out>disagree: first order in dt</system-out>"));
}

BOOST_AUTO_TEST_CASE(messages_carry_numbers_limit_and_reason) {
    const std::string xml = junit_xml(document_of({{"verdict", "disagree"},
                                                   {"expected", false},
                                                   {"difference", 0.0047},
                                                   {"uncertainty", nullptr},
                                                   {"limit", 0.001},
                                                   {"limit_reason", "second order"},
                                                   {"reason", "grows with dt"}}));
    BOOST_TEST(
        contains(xml, "<failure message=\"disagree, difference 0.0047, limit 0.001 (second order): "
                      "grows with dt\"/>"));
}

BOOST_AUTO_TEST_CASE(certificates_count_too) {
    const json pair = {
        {"case", "gas"}, {"a", "native-dem"}, {"b", "lammps"}, {"verdict", "disagree"}};
    const std::string xml = junit_xml({{"certificate", {{"pairs", {pair}}}}});
    BOOST_TEST(contains(xml, "<testsuite name=\"certificate\" tests=\"1\" failures=\"1\""));
}

BOOST_AUTO_TEST_CASE(text_is_valid_xml) {
    const std::string xml = junit_xml(document_of(
        {{"verdict", "not_installed"}, {"reason", "<a href=\"x\"> & \x1b[31m\xff\nsecond line"}}));
    BOOST_TEST(contains(xml, "&lt;a href=&quot;x&quot;&gt; &amp; ?[31m\xEF\xBF\xBD&#10;second"));
    BOOST_TEST(!contains(xml, "\x1b"));
    BOOST_TEST(!contains(xml, "\xff"));
}

// Every byte, and every character that XML 1.0 forbids, in each place that takes a text.
BOOST_AUTO_TEST_CASE(whatever_texts_hold_the_xml_is_well_formed) {
    std::string all = "\xEF\xBF\xBE \xEF\xBF\xBF \xED\xA0\x80 \xF0\x9F\xBF\xBE ]]> ";
    for (int byte = 0; byte < 256; ++byte)
        all += static_cast<char>(byte);
    json verdict = {{"verdict", "disagree"}, {"code", all},   {"observable", all}, {"kind", all},
                    {"against", all},        {"reason", all}, {"setting", all}};
    for (const bool expected : {true, false}) {
        verdict["expected"] = expected;
        const std::string xml = junit_xml({{"cases", {{{"case", all}, {"verdicts", {verdict}}}}}});
        BOOST_TEST(crossgrain::tests::fault_in_xml(xml) == "");
    }
    // The checker itself sees faults.
    for (const char* bad : {"<a>", "<a></b>", "<a>&</a>", "<a b=\"<\"/>", "<a>\xff</a>",
                            "<a>\x01</a>", "<a>\xEF\xBF\xBE</a>", "<a>< </a>", "</a>"})
        BOOST_TEST(crossgrain::tests::fault_in_xml(bad) != "", bad);
}

BOOST_AUTO_TEST_CASE(an_empty_document_has_no_tests) {
    BOOST_TEST(contains(junit_xml(json::object()), "tests=\"0\""));
    BOOST_TEST(contains(junit_xml(json()), "tests=\"0\""));
}

BOOST_AUTO_TEST_SUITE_END()
