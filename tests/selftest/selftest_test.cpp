// Protects the selftest itself: it must see what is planted, blame the right one, say so when a
// planted defect is missed or can no longer be planted, and count false alarms as such.
#include "native/base/errors.hpp"
#include "tests/selftest/selftest.hpp"
#include "tests/selftest/selftest_culprit.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

using namespace crossgrain;
using namespace crossgrain::selftest;
using compare::Kind;
using compare::Outcome;
using compare::Verdict;

namespace {

const std::string defects = CROSSGRAIN_SOURCE_DIR "/tests/selftest/defects";

Verdict verdict(const std::string& code, Kind kind, const std::string& against, Outcome outcome) {
    return {.code = code,
            .observable = "trajectory",
            .kind = kind,
            .against = {kind == Kind::parity || kind == Kind::agree
                            ? compare::Against::Kind::code
                            : compare::Against::Kind::closed_form,
                        against},
            .outcome = outcome,
            .expected = outcome == Outcome::agree};
}

/// All pairs of a, b, c; those with `bad` disagree.
std::vector<Verdict> pairs_with(const std::string& bad) {
    std::vector<Verdict> all;
    for (const auto& [x, y] : {std::pair{"a", "b"}, {"a", "c"}, {"b", "c"}}) {
        all.push_back(
            verdict(x, Kind::parity, y, x == bad || y == bad ? Outcome::disagree : Outcome::agree));
    }
    return all;
}

selftest::SelftestReport run_all(const selftest::SelftestCatalogue& catalogue) {
    const tests::TemporaryDirectory directory;
    crossgrain::run::Settings settings;
    settings.results = directory.path();
    return selftest::run_selftest(catalogue, settings, {});
}

/// One group of the shipped catalogue, with only the defects named.
selftest::SelftestCatalogue only(const std::vector<std::string>& names) {
    auto catalogue = selftest::load_selftest(defects);
    catalogue.nulls.clear();
    for (auto& group : catalogue.groups) {
        std::erase_if(group.defects, [&](const auto& defect) {
            return std::ranges::find(names, defect.name) == names.end();
        });
    }
    std::erase_if(catalogue.groups, [](const auto& group) { return group.defects.empty(); });
    return catalogue;
}

selftest::SelftestCatalogue with_file(const std::string& text) {
    const tests::TemporaryDirectory directory;
    std::ofstream(directory.path() / "some.toml") << text;
    return selftest::load_selftest(directory.path());
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_against_one_names_the_one) {
    const auto bad = pairs_with("b");
    BOOST_TEST(selftest::culprit_of(selftest::new_objections(pairs_with(""), bad), bad).value() ==
               "b");
}

BOOST_AUTO_TEST_CASE(one_against_one_names_nobody) {
    const std::vector<Verdict> pair{verdict("a", Kind::parity, "b", Outcome::disagree)};
    BOOST_TEST(!selftest::culprit_of(pair, pair));
}

BOOST_AUTO_TEST_CASE(a_closed_form_breaks_the_tie) {
    const std::vector<Verdict> all{verdict("a", Kind::parity, "b", Outcome::disagree),
                                   verdict("a", Kind::exact, "analytic:zero", Outcome::disagree)};
    BOOST_TEST(selftest::culprit_of(all, all).value() == "a");
    BOOST_TEST((selftest::most_telling(all, "a").kind == Kind::exact));
}

BOOST_AUTO_TEST_CASE(when_all_object_to_a_reference_it_is_the_reference) {
    std::vector<Verdict> all;
    for (const char* code : {"a", "b"})
        all.push_back(verdict(code, Kind::published, "published:x", Outcome::disagree));
    BOOST_TEST(selftest::culprit_of(all, all).value() == "published");
    const auto one = std::vector<Verdict>{all.front()};
    BOOST_TEST(selftest::culprit_of(one, all).value() == "a");
}

BOOST_AUTO_TEST_CASE(what_was_wrong_before_or_is_undecided_is_no_objection) {
    const auto bad = pairs_with("b");
    BOOST_TEST(selftest::new_objections(bad, bad).empty());
    const std::vector<Verdict> unsure{verdict("a", Kind::agree, "b", Outcome::undecided)};
    BOOST_TEST(selftest::new_objections({}, unsure).empty());
}

BOOST_AUTO_TEST_CASE(the_shipped_catalogue_is_large_enough) {
    const auto catalogue = selftest::load_selftest(defects);
    BOOST_TEST(catalogue.defect_count() >= 40U);
    BOOST_TEST(!catalogue.nulls.empty());
}

// One defect of every way that needs no foreign program.
BOOST_AUTO_TEST_CASE(planted_defects_are_caught_and_blamed) {
    const auto report = run_all(only(
        {"restitution as its square", "reduced mass m/2 at walls", "a grain vanishes",
         "orientations not handed on", "gravity on wall sites",
         "rest particles lost in a collision", "sign of a published value", "reference file empty",
         "published value under another name", "wrong bin width", "inertia as printed",
         "gravity 5 % off", "dissipation 20 % off", "every second bin one frame late"}));
    BOOST_TEST(report.defects.size() == 14U);
    for (const auto& d : report.defects) {
        BOOST_TEST(d.caught, d.name);
        BOOST_TEST(d.culprit_right, d.name + ": " + d.culprit + ", " + d.by);
    }
    BOOST_TEST(report.passed());
    const auto document = selftest::selftest_document(report);
    BOOST_TEST(document["defects"].size() == 14U);
    BOOST_TEST(document["null"]["comparisons"] == 0);
}

BOOST_AUTO_TEST_CASE(a_defect_that_nothing_looks_at_is_reported_as_missed) {
    auto catalogue = only({"restitution as its square"});
    catalogue.groups.front().defects.front().factor = 1.0;
    const auto report = run_all(catalogue);
    BOOST_TEST(!report.defects.front().caught);
    BOOST_TEST(!report.passed());
}

BOOST_AUTO_TEST_CASE(null_comparisons_count_what_they_find) {
    selftest::SelftestCatalogue catalogue;
    catalogue.nulls.push_back({.case_name = defects + "/cases/funnel.toml",
                               .code = "native-hopper",
                               .against = "native-hopper",
                               .rounds = 3});
    const auto clean = run_all(catalogue);
    BOOST_TEST(clean.null.comparisons == 24U);
    BOOST_TEST(clean.null.false_alarms == 0U);
    // Not null at all: the other one's sweep goes from the top. Each round must raise an alarm.
    catalogue.nulls.front().edit = selftest::TextEdit{"\"standard\"", "\"top-to-bottom\""};
    const auto wrong = run_all(catalogue);
    BOOST_TEST(wrong.null.false_alarms >= 3U);
    BOOST_TEST(!wrong.passed());
}

BOOST_AUTO_TEST_CASE(defects_that_cannot_be_planted_are_errors) {
    auto catalogue = only({"reduced mass m/2 at walls"});
    catalogue.groups.front().defects.front().edit.from = "no such text";
    BOOST_CHECK_THROW(run_all(catalogue), CaseError);
    catalogue = only({"a grain vanishes"});
    catalogue.groups.front().defects.front().filter = "no-such-filter";
    BOOST_CHECK_THROW(run_all(catalogue), CaseError);
    catalogue = only({"restitution as its square"});
    catalogue.groups.front().defects.front().spoiled = "no-such-measurement";
    BOOST_CHECK_THROW(run_all(catalogue), CaseError);
}

BOOST_AUTO_TEST_CASE(catalogues_with_errors_are_refused) {
    const std::string head = "[[group]]\ncase = \"wall-bounce\"\ncodes = [\"native-dem\"]\n";
    const std::string defect = "[[group.defect]]\nname = \"x\"\nkind = \"frames\"\n"
                               "code = \"native-dem\"\nfilter = \"truncated\"\n";
    BOOST_TEST(with_file(head + defect).defect_count() == 1U);
    BOOST_CHECK_THROW(with_file(head), CaseError);                    // holds no defects
    BOOST_CHECK_THROW(with_file(head + defect + defect), CaseError);  // one name twice
    BOOST_CHECK_THROW(with_file(head + defect + "colour = 1\n"), CaseError);
    BOOST_CHECK_THROW(
        with_file("[[group]]\ncase = \"wall-bounce\"\ncodes = [\"lamps\"]\n" + defect), CaseError);
}
