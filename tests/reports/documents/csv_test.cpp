#include <boost/test/unit_test.hpp>

#include "reports/documents/csv.hpp"

using namespace crossgrain::reports;
using nlohmann::json;

BOOST_AUTO_TEST_SUITE(csv)

BOOST_AUTO_TEST_CASE(measurements_have_one_row_each_with_all_digits) {
    const json measurement = {{"code", "lammps"},
                              {"variant", "full"},
                              {"observable", "restitution"},
                              {"value", 1.0 / 3.0},
                              {"stderr", nullptr},
                              {"systematic", 0.5},
                              {"ci95", {0.25, 0.75}},
                              {"n", 12},
                              {"unit", "1"},
                              {"settings", {{"dt", 0.001}, {"k_min", 1}}}};
    const json document = {
        {"cases", {{{"case", "bed"}, {"measurements", {measurement, measurement}}}}}};
    const std::string row =
        "bed,lammps,full,restitution,0.3333333333333333,,0.5,0.25,0.75,12,1,dt=0.001; k_min=1\n";
    BOOST_TEST(measurements_csv(document) ==
               "case,code,variant,observable,value,stderr,systematic,ci95_low,ci95_high,n,unit,"
               "settings\n" +
                   row + row);
}

BOOST_AUTO_TEST_CASE(verdicts_quote_commas_quotes_and_line_ends) {
    const json verdict = {{"code", "yade"},
                          {"against", "analytic:restitution"},
                          {"observable", "restitution"},
                          {"kind", "exact"},
                          {"setting", "full, dt = t_c/100"},
                          {"difference", 4.7e-3},
                          {"uncertainty", 0},
                          {"limit", 1e-3},
                          {"verdict", "disagree"},
                          {"expected", false},
                          {"reason", "\"first\norder\""}};
    const json document = {{"cases", {{{"case", "c"}, {"verdicts", {verdict}}}}}};
    BOOST_TEST(verdicts_csv(document) ==
               "case,code,against,observable,kind,setting,difference,uncertainty,limit,verdict,"
               "expected,reason,limit_reason\n"
               "c,yade,analytic:restitution,restitution,exact,\"full, dt = t_c/100\",0.0047,0,"
               "0.001,disagree,false,\"\"\"first\norder\"\"\",\n");
}

// Spreadsheets run what begins like a formula; a negative number stays a number.
BOOST_AUTO_TEST_CASE(texts_are_never_formulas) {
    BOOST_TEST(csv_field("=1+1") == "'=1+1");
    BOOST_TEST(csv_field("@x") == "'@x");
    BOOST_TEST(csv_field("-x,y") == "\"'-x,y\"");
    BOOST_TEST(csv_field("a=b") == "a=b");
    BOOST_TEST(csv_field("\x1b\xff") == "\\x1b\\xff");
    const json verdict = {{"code", "+code"}, {"difference", -0.5}};
    const json document = {{"cases", {{{"case", "c"}, {"verdicts", {verdict}}}}}};
    BOOST_TEST(verdicts_csv(document).ends_with("\nc,'+code,,,,,-0.5,,,,,,\n"));
}

BOOST_AUTO_TEST_CASE(what_is_missing_is_empty) {
    BOOST_TEST(verdicts_csv(json::object()).find('\n') != std::string::npos);
    const json document = {{"cases", {{{"case", "c"}, {"measurements", {json::object()}}}}}};
    BOOST_TEST(measurements_csv(document).ends_with("\nc,,,,,,,,,,,\n"));
}

BOOST_AUTO_TEST_SUITE_END()
