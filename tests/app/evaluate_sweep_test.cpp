// Protects the judge over the variants of a sweep: trends, pairs of variants, expectations by
// variant. The runs are made up, so that every answer is known.
#include "app/evaluate.hpp"

#include "cases/catalog/case.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace crossgrain;
using app::CaseRuns;
using app::Evaluation;
using catalog::Aspect;
using catalog::Check;
using catalog::CheckKind;
using compare::Outcome;

namespace {

catalog::Case case_with(std::vector<Check> checks) {
    auto result = catalog::load_case(CROSSGRAIN_SOURCE_DIR "/tests/app/cases/small-sweep.toml",
                                     catalog::Suite::full);
    result.checks = std::move(checks);
    return result;
}

store::RunRecord run_of(const std::string& variant, double value, double standard_error = 0.01) {
    store::RunRecord record{
        .case_name = "small-sweep", .variant = variant, .code = "a", .seed = 1, .status = "ok"};
    record.results.measurements.push_back(
        {.observable = "slope", .value = value, .standard_error = standard_error, .n = 20});
    return record;
}

/// Half-step constant in dt, predicted growing.
std::vector<store::RunRecord> runs() {
    return {run_of("verlet-half-step/dt=0.001", 1.0), run_of("verlet-half-step/dt=0.002", 1.01),
            run_of("verlet-predicted/dt=0.001", 1.0), run_of("verlet-predicted/dt=0.002", 2.0)};
}

Check trend_check(Aspect aspect) {
    Check check;
    check.kind = CheckKind::published;
    check.observable = "slope";
    check.aspect = aspect;
    check.along = "dt";
    check.against = "published:test/flat";
    check.limit = 0.2;
    check.reason = "a test";
    return check;
}

const published::PublishedValues& literature() {
    static const tests::TemporaryDirectory directory;
    static const published::PublishedValues values = [] {
        std::ofstream(directory.path() / "test.toml")
            << "source = \"a test\"\n[value.flat]\nquantity = \"slope\"\ntrend = \"constant\"\n"
               "place = \"here\"\nobtained = \"made up\"\n[value.number]\nquantity = \"slope\"\n"
               "value = 1.0\nerror = 0.0\nplace = \"here\"\nobtained = \"made up\"\n";
        return published::PublishedValues(directory.path());
    }();
    return values;
}

Evaluation evaluation_of(const catalog::Case& the_case, std::vector<store::RunRecord> records) {
    return app::evaluate(CaseRuns(the_case, std::move(records)), literature());
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_trend_is_judged_once_for_each_group_of_variants) {
    const auto the_case = case_with({trend_check(Aspect::constant)});
    const auto verdicts = evaluation_of(the_case, runs()).verdicts;
    BOOST_REQUIRE(verdicts.size() == 2U);
    BOOST_TEST(verdicts[0].setting == "verlet-half-step");
    BOOST_CHECK(verdicts[0].outcome == Outcome::agree);
    BOOST_TEST(verdicts[1].setting == "verlet-predicted");
    BOOST_CHECK(verdicts[1].outcome == Outcome::disagree);
    BOOST_TEST(!verdicts[1].expected);
}

BOOST_AUTO_TEST_CASE(an_expectation_by_variant_holds_for_its_group_only) {
    auto check = trend_check(Aspect::constant);
    check.expect_in = {{"verlet-predicted/*", "disagree"}};
    check.expect_reason = "another scheme";
    const auto verdicts = evaluation_of(case_with({check}), runs()).verdicts;
    BOOST_TEST(verdicts.at(0).expected);
    BOOST_TEST(verdicts.at(1).expected);
    check.expect_in = {{"verlet-half-step/*", "disagree"}};
    const auto wrong = evaluation_of(case_with({check}), runs()).verdicts;
    BOOST_TEST(!wrong.at(0).expected);
}

BOOST_AUTO_TEST_CASE(a_trend_without_its_reference_or_a_run_is_never_green) {
    auto check = trend_check(Aspect::increasing);  // the literature says "constant"
    BOOST_CHECK(evaluation_of(case_with({check}), runs()).verdicts.at(1).outcome ==
                Outcome::no_reference);
    check = trend_check(Aspect::constant);
    check.against = "published:test/number";
    BOOST_CHECK(evaluation_of(case_with({check}), runs()).verdicts.at(0).outcome ==
                Outcome::no_reference);
    check = trend_check(Aspect::constant);
    auto records = runs();
    records[1].status = "run_failed";
    BOOST_CHECK(evaluation_of(case_with({check}), records).verdicts.at(0).outcome ==
                Outcome::run_failed);
    records = runs();
    records[1].results.measurements.clear();
    BOOST_CHECK(evaluation_of(case_with({check}), records).verdicts.at(0).outcome ==
                Outcome::undecided);
}

// Four replicas at each of four points of y = x^2, all off by the same share, up and down: the
// points lie on the law, so that the residuals know of no error, but the replicas do.
BOOST_AUTO_TEST_CASE(a_fit_has_the_error_of_its_replicas_and_the_spread_of_its_windows) {
    auto the_case = case_with({});
    the_case.fits = {
        {.name = "power", .law = catalog::FitLaw::exponent, .observable = "slope", .along = "x"}};
    std::vector<store::RunRecord> records;
    double x = 1;
    for (const auto& variant : the_case.variants) {
        std::int64_t replica = 0;
        for (const double off : {-0.03, -0.01, 0.01, 0.03}) {
            auto record = run_of(variant.name, x * x * (1 + off), 0);
            record.replica = replica++;
            record.results.measurements[0].settings = {{"x", x}};
            records.push_back(std::move(record));
        }
        x *= 2;
    }
    const auto measured = evaluation_of(the_case, std::move(records)).measurements;
    const auto fit = std::ranges::find_if(
        measured, [](const auto& m) { return m.combined.measurement.observable == "power"; });
    BOOST_TEST_REQUIRE((fit != measured.end()));
    const auto& m = fit->combined.measurement;
    BOOST_TEST(m.value == 2.0, boost::test_tools::tolerance(1e-9));
    // s = .0258 of a replica, .0129 of a point, over ln 2 sqrt(5): four points in steps of ln 2.
    BOOST_TEST(m.settings.at("error_of_bootstrap") == 0.0129 / std::log(2.0) / std::sqrt(5.0),
               boost::test_tools::tolerance(0.15));
    BOOST_TEST(m.standard_error >= m.settings.at("error_of_fit"));
    BOOST_TEST(m.standard_error >= m.settings.at("error_of_bootstrap"));
    BOOST_TEST(m.systematic < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_published_trend_is_no_number_to_compare_with) {
    auto check = trend_check(Aspect::value);
    const auto verdicts = evaluation_of(case_with({check}), runs()).verdicts;
    BOOST_REQUIRE(verdicts.size() == 4U);
    BOOST_CHECK(verdicts[0].outcome == Outcome::no_reference);
}

BOOST_AUTO_TEST_CASE(two_variants_of_one_code_are_compared) {
    Check check;
    check.kind = CheckKind::agree;
    check.observable = "slope";
    check.between = {"verlet-half-step/dt=0.001", "verlet-predicted/dt=0.001"};
    check.limit = 0.2;
    check.reason = "a test";
    const auto same = evaluation_of(case_with({check}), runs()).verdicts;
    BOOST_REQUIRE(same.size() == 1U);
    BOOST_CHECK(same[0].outcome == Outcome::agree);
    BOOST_TEST(same[0].against == "variant verlet-predicted/dt=0.001");
    check.between[1] = "verlet-predicted/dt=0.002";
    BOOST_CHECK(evaluation_of(case_with({check}), runs()).verdicts.at(0).outcome ==
                Outcome::disagree);
}
