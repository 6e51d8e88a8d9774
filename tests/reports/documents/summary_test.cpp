// Protects what is said over all cases: corrected verdicts, bias and deviation by code, and who was
// compared with whom. The verdicts are made up, so that every answer is known.
#include "reports/documents/summary.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::judge;
using namespace crossgrain::session;
using compare::Kind;
using compare::Outcome;
using compare::Verdict;

namespace {

session::SessionReport report_of(std::vector<Verdict> verdicts) {
    auto the_case = std::make_shared<const catalog::Case>(catalog::load_case(
        CROSSGRAIN_SOURCE_DIR "/tests/app/cases/small-gas.toml", catalog::Suite::full));
    session::SessionReport report;
    judge::CaseRuns runs(*the_case, {});
    report.cases.push_back({the_case, std::move(runs), {.verdicts = std::move(verdicts)}});
    correct_for_many(report.cases);
    return report;
}

Verdict claim(Outcome outcome, double p_equivalent, double p_different) {
    return {.code = "a",
            .observable = "slope",
            .kind = Kind::agree,
            .against = {compare::Against::Kind::code, "b"},
            .difference = 0.1,
            .uncertainty = 0.1,
            .outcome = outcome,
            .p_equivalent = p_equivalent,
            .p_different = p_different};
}

Verdict ratio(const std::string& code, double model, double reference) {
    return {.code = code,
            .observable = "restitution",
            .aspect = compare::Aspect::limit,
            .kind = Kind::exact,
            .difference = model - reference,
            .outcome = Outcome::agree,
            .reference = reference};
}

}  // namespace

BOOST_AUTO_TEST_CASE(weak_claims_do_not_stand_among_many) {
    std::vector<Verdict> many(20, claim(Outcome::agree, 0.001, 1));
    many.push_back(claim(Outcome::disagree, 1, 0.04));
    many.push_back(claim(Outcome::disagree, 1, 1e-6));
    many.push_back(claim(Outcome::agree, 0.04, 1));
    const auto report = report_of(many);
    const auto& verdicts = report.cases[0].evaluation.verdicts;
    BOOST_CHECK(verdicts[0].corrected == Outcome::agree);
    BOOST_CHECK(verdicts[20].corrected == Outcome::undecided);  // .04 of 23 is no claim
    BOOST_CHECK(verdicts[21].corrected == Outcome::disagree);
    BOOST_CHECK(verdicts[22].corrected == Outcome::undecided);
    const auto counts = reports::correction_counts(report);
    BOOST_TEST(counts.members == 23U);
    BOOST_TEST(counts.agree == 21U);
    BOOST_TEST(counts.agree_corrected == 20U);
    BOOST_TEST(counts.disagree == 2U);
    BOOST_TEST(counts.disagree_corrected == 1U);
}

BOOST_AUTO_TEST_CASE(a_single_claim_needs_no_correction) {
    const auto report = report_of({claim(Outcome::disagree, 1, 0.04)});
    BOOST_CHECK(report.cases[0].evaluation.verdicts[0].corrected == Outcome::disagree);
}

BOOST_AUTO_TEST_CASE(numbers_without_scatter_are_no_claims) {
    auto exact = ratio("a", 0.8, 0.8);
    exact.p_equivalent = 0;
    exact.p_different = 1;
    auto failed = claim(Outcome::run_failed, 1, 1);
    const auto report = report_of({exact, failed});
    for (const auto& v : report.cases[0].evaluation.verdicts)
        BOOST_TEST(!v.corrected.has_value());
}

BOOST_AUTO_TEST_CASE(bias_is_by_observable_and_code) {
    const auto rows = reports::bias_rows(
        report_of({ratio("a", 0.88, 0.8), ratio("a", 1.1, 1.0), ratio("b", 0.8, 0.8),
                   ratio("a", 1, -1), ratio("b", 1, 0), claim(Outcome::agree, 0, 1)}));
    BOOST_REQUIRE(rows.size() == 2U);
    BOOST_TEST(rows[0].observable == "restitution");
    BOOST_TEST(rows[0].code == "a");
    BOOST_TEST(rows[0].comparisons == 2U);
    BOOST_TEST(rows[0].bias == 1.1, tt::tolerance(1e-9));
    BOOST_TEST(rows[0].statistics->relative_deviation < 1e-9);
    BOOST_TEST(rows[1].bias == 1.0, tt::tolerance(1e-12));
    BOOST_TEST(!rows[1].statistics.has_value());
}

BOOST_AUTO_TEST_CASE(pairs_are_counted_by_outcome) {
    auto variant = claim(Outcome::agree, 0, 1);
    variant.against = {compare::Against::Kind::variant, "double"};
    auto own = claim(Outcome::agree, 0, 1);
    own.against = {compare::Against::Kind::own_observable, "mean_speed"};
    const auto report = report_of({claim(Outcome::agree, 0, 1), claim(Outcome::disagree, 1, 0),
                                   claim(Outcome::undecided, 0.5, 1),
                                   claim(Outcome::not_installed, 1, 1), variant, own});
    const auto rows = reports::pair_rows(report);
    BOOST_REQUIRE(rows.size() == 1U);
    BOOST_TEST(rows[0].agree == 1U);
    BOOST_TEST(rows[0].disagree == 1U);
    BOOST_TEST(rows[0].undecided == 1U);
    BOOST_TEST(rows[0].absent == 1U);
    const auto document = reports::summary_document(report);
    BOOST_TEST(document["pairs"][0]["a"] == "a");
    BOOST_TEST(document["correction"]["verdicts"] == 5);
    BOOST_TEST(reports::summary_tables(report).find("1 agree, 1 disagree") != std::string::npos);
}
