// Protects the judge over the variants of a sweep: trends, pairs of variants, expectations by
// variant. The runs are made up, so that every answer is known.
#include "reference/judge/evaluate.hpp"

#include "cases/catalog/case.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace crossgrain;
using catalog::Aspect;
using catalog::Check;
using catalog::CheckKind;
using catalog::Reference;
using compare::Outcome;
using judge::CaseRuns;
using judge::Evaluation;

namespace {

catalog::Case case_with(std::vector<Check> checks) {
    auto result = catalog::load_case(CROSSGRAIN_SOURCE_DIR "/tests/app/cases/small-sweep.toml",
                                     catalog::Suite::full);
    result.checks = std::move(checks);
    return result;
}

store::RunRecord run_of(const std::string& variant, double value, double standard_error = 0.01) {
    store::RunRecord record{.case_name = "small-sweep",
                            .variant = variant,
                            .code = "a",
                            .seed = 1,
                            .status = store::RunStatus::ok};
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
    check.against = {Reference::Kind::published, "test/flat"};
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

judge::Evaluation evaluation_of(const catalog::Case& the_case,
                                std::vector<store::RunRecord> records) {
    return judge::evaluate(judge::CaseRuns(the_case, std::move(records)), literature());
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_trend_is_judged_once_for_each_group_of_variants) {
    const auto the_case = case_with({trend_check(Aspect::constant)});
    const auto verdicts = evaluation_of(the_case, runs()).verdicts;
    BOOST_REQUIRE(verdicts.size() == 2U);
    BOOST_TEST(setting_text(verdicts[0]) == "verlet-half-step");
    BOOST_CHECK(verdicts[0].outcome == Outcome::agree);
    BOOST_TEST(setting_text(verdicts[1]) == "verlet-predicted");
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
    check.against = {Reference::Kind::published, "test/number"};
    BOOST_CHECK(evaluation_of(case_with({check}), runs()).verdicts.at(0).outcome ==
                Outcome::no_reference);
    check = trend_check(Aspect::constant);
    auto records = runs();
    records[1].status = store::RunStatus::run_failed;
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

namespace {

/// Two replicas of code at each point of y = x^power, 1 % off to either side.
std::vector<store::RunRecord> power_law(const catalog::Case& the_case, const std::string& code,
                                        double power) {
    std::vector<store::RunRecord> records;
    double x = 1;
    for (const auto& variant : the_case.variants) {
        for (const std::int64_t replica : {0, 1}) {
            auto record = run_of(variant.name, std::pow(x, power) * (replica == 0 ? 0.99 : 1.01));
            record.code = code;
            record.replica = replica;
            record.results.measurements[0].settings = {{"x", x}};
            records.push_back(std::move(record));
        }
        x *= 2;
    }
    return records;
}

Check agree_check(const std::string& observable, double limit) {
    Check check;
    check.kind = CheckKind::agree;
    check.observable = observable;
    check.limit = limit;
    check.reason = "a test";
    return check;
}

catalog::Case fitted_case(const Check& check) {
    auto the_case = case_with({check});
    the_case.fits = {
        {.name = "power", .law = catalog::FitLaw::exponent, .observable = "slope", .along = "x"},
        {.name = "rise", .law = catalog::FitLaw::local_slope, .observable = "slope", .along = "x"}};
    return the_case;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_fit_is_judged_once_between_codes_and_against_the_literature) {
    auto check = agree_check("power", 0.2);
    check.expect_in = {{"*", "disagree"}};  // of variants, to none of which a fit belongs
    const auto judged = [&](double other) {
        const auto the_case = fitted_case(check);
        auto records = power_law(the_case, "a", 1);
        for (auto& record : power_law(the_case, "b", other))
            records.push_back(std::move(record));
        return evaluation_of(the_case, std::move(records)).verdicts;
    };
    const auto same = judged(1.001);  // to the last bit the same would be one output read twice
    BOOST_REQUIRE(same.size() == 1U);
    BOOST_CHECK(same[0].outcome == Outcome::agree);
    BOOST_TEST(same[0].expected);
    BOOST_TEST(setting_text(same[0]) == "");
    BOOST_CHECK(judged(2).at(0).outcome == Outcome::disagree);
    check.kind = CheckKind::published;
    check.against = {Reference::Kind::published, "test/number"};  // 1
    BOOST_CHECK(judged(1).at(0).outcome == Outcome::agree);
    BOOST_CHECK(judged(2).at(1).outcome == Outcome::disagree);
}

BOOST_AUTO_TEST_CASE(a_fit_with_a_failed_run_or_too_few_points_is_never_green) {
    auto check = agree_check("power", 0.2);
    check.kind = CheckKind::published;
    check.against = {Reference::Kind::published, "test/number"};
    const auto the_case = fitted_case(check);
    auto failed = power_law(the_case, "a", 1);
    failed[3].status = store::RunStatus::run_failed;
    BOOST_CHECK(evaluation_of(the_case, failed).verdicts.at(0).outcome == Outcome::run_failed);
    auto few = power_law(the_case, "a", 1);
    for (std::size_t i = 2; i < few.size(); ++i)
        few[i].status = store::RunStatus::not_run;
    BOOST_CHECK(evaluation_of(the_case, few).verdicts.at(0).outcome == Outcome::undecided);
}

// y = x at 1, 2, 4, 8: the slope is 1 everywhere, y itself only at the first point.
BOOST_AUTO_TEST_CASE(an_observable_agrees_with_another_of_the_same_code_or_does_not) {
    auto check = agree_check("slope", 0.4);
    check.with = "rise";
    const auto the_case = fitted_case(check);
    const auto verdicts = evaluation_of(the_case, power_law(the_case, "a", 1)).verdicts;
    BOOST_REQUIRE(verdicts.size() == 4U);
    BOOST_TEST(to_string(verdicts[1].against) == "its own rise");
    BOOST_CHECK(verdicts[0].outcome == Outcome::undecided);  // no slope at the ends
    BOOST_CHECK(verdicts[2].outcome == Outcome::disagree);   // 4 against 1
    check.limit = 3;
    const auto wide = fitted_case(check);
    BOOST_CHECK(evaluation_of(wide, power_law(wide, "a", 1)).verdicts.at(1).outcome ==
                Outcome::agree);  // 2 against 1
}

// A run in a hundred is called unsteady by chance and measures nothing: of many replicas it must
// not cost all the others. Two of eleven are no chance, nor is one of nine.
BOOST_AUTO_TEST_CASE(one_of_many_replicas_may_lack_a_measurement) {
    const auto the_case = case_with({});
    const std::string& variant = the_case.variants[0].name;
    const auto combined = [&](std::int64_t replicas, std::int64_t without) {
        std::vector<store::RunRecord> records;
        for (std::int64_t replica = 0; replica < replicas; ++replica) {
            auto record = run_of(variant, 1 + 0.1 * static_cast<double>(replica % 2));
            record.replica = replica;
            if (replica < without) record.results.measurements.clear();
            records.push_back(std::move(record));
        }
        return judge::CaseRuns(the_case, std::move(records)).combined("a", 0, 0, "slope");
    };
    const auto most = combined(11, 1);
    BOOST_TEST_REQUIRE(most.has_value());
    BOOST_TEST(most->replicas == 10U);
    BOOST_TEST(most->measurement.settings.at("replicas_without") == 1);
    BOOST_TEST(!combined(11, 0)->measurement.settings.contains("replicas_without"));
    BOOST_TEST(!combined(11, 2).has_value());
    BOOST_TEST(!combined(9, 1).has_value());
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
    BOOST_TEST(to_string(same[0].against) == "variant verlet-predicted/dt=0.001");
    check.between[1] = "verlet-predicted/dt=0.002";
    BOOST_CHECK(evaluation_of(case_with({check}), runs()).verdicts.at(0).outcome ==
                Outcome::disagree);
}

namespace {

std::vector<store::RunRecord> two_codes() {
    auto records = runs();
    for (auto record : runs()) {
        record.code = "b";
        record.results.measurements[0].value += 1e-3;
        records.push_back(std::move(record));
    }
    return records;
}

}  // namespace

// The order of the report: by variant, then by code.
BOOST_AUTO_TEST_CASE(a_check_is_asked_of_its_variants_and_codes_only) {
    Check check = trend_check(Aspect::value);
    check.against = {Reference::Kind::published, "test/number"};
    check.variants = {"*/dt=0.002"};
    const auto verdicts = evaluation_of(case_with({check}), two_codes()).verdicts;
    BOOST_REQUIRE(verdicts.size() == 4U);
    BOOST_TEST(setting_text(verdicts[1]) == "verlet-half-step/dt=0.002");
    BOOST_TEST(verdicts[1].code == "b");
    BOOST_TEST(setting_text(verdicts[2]) == "verlet-predicted/dt=0.002");
    BOOST_TEST(verdicts[2].code == "a");
    check.codes = {"b"};
    const auto of_b = evaluation_of(case_with({check}), two_codes()).verdicts;
    BOOST_REQUIRE(of_b.size() == 2U);
    BOOST_TEST(of_b[0].code == "b");
    check.variants = {"nothing of this name"};
    BOOST_TEST(evaluation_of(case_with({check}), two_codes()).verdicts.empty());
}

BOOST_AUTO_TEST_CASE(an_absent_code_costs_its_own_verdicts_only) {
    auto records = two_codes();
    records[4].status = store::RunStatus::not_installed;  // b, first variant
    records[4].reason = "no b here";
    Check number = trend_check(Aspect::value);
    number.against = {Reference::Kind::published, "test/number"};
    const auto alone = evaluation_of(case_with({number}), records).verdicts;
    BOOST_REQUIRE(alone.size() == 8U);
    BOOST_CHECK(alone[0].outcome == Outcome::agree);
    BOOST_CHECK(alone[1].outcome == Outcome::not_installed);
    BOOST_TEST(alone[1].reason == "no b here");
    BOOST_TEST(alone[1].absent_code == "");
    BOOST_CHECK(alone[3].outcome == Outcome::agree);
    const auto pairs = evaluation_of(case_with({agree_check("slope", 0.2)}), records).verdicts;
    BOOST_REQUIRE(pairs.size() == 4U);
    BOOST_CHECK(pairs[0].outcome == Outcome::not_installed);
    BOOST_TEST(pairs[0].reason == "b: no b here");
    BOOST_TEST(pairs[0].absent_code == "b");
    BOOST_CHECK(pairs[1].outcome == Outcome::agree);
    BOOST_TEST(pairs[1].absent_code == "");
}

BOOST_AUTO_TEST_CASE(of_two_variants_either_may_be_absent_or_left_out) {
    Check check = agree_check("slope", 0.2);
    check.between = {"verlet-half-step/dt=0.001", "verlet-predicted/dt=0.001"};
    for (const std::size_t gone : {0U, 2U}) {
        auto records = runs();
        records[gone].status = store::RunStatus::run_failed;
        const auto verdicts = evaluation_of(case_with({check}), records).verdicts;
        BOOST_REQUIRE(verdicts.size() == 1U);
        BOOST_CHECK(verdicts[0].outcome == Outcome::run_failed);
    }
    check.between[1] = "not in this suite";
    BOOST_TEST(evaluation_of(case_with({check}), runs()).verdicts.empty());
}

// A fit over the variants is the same in each of them: it would agree with itself.
BOOST_AUTO_TEST_CASE(a_fit_is_not_compared_between_variants) {
    auto check = agree_check("power", 0.2);
    check.between = {"verlet-half-step/dt=0.001", "verlet-predicted/dt=0.001"};
    const auto the_case = fitted_case(check);
    const auto verdicts = evaluation_of(the_case, power_law(the_case, "a", 1)).verdicts;
    BOOST_CHECK(verdicts.at(0).outcome == Outcome::undecided);
}

// One of the runs may be left out of a fit, but parity compares runs.
BOOST_AUTO_TEST_CASE(parity_of_what_no_run_measures_is_undecided) {
    auto check = agree_check("power", 0.2);
    check.kind = CheckKind::parity;
    const auto the_case = fitted_case(check);
    auto records = power_law(the_case, "a", 1);
    for (auto& record : power_law(the_case, "b", 1))
        records.push_back(std::move(record));
    records[0].status = store::RunStatus::not_run;
    BOOST_CHECK(evaluation_of(the_case, records).verdicts.at(0).outcome == Outcome::undecided);
}
