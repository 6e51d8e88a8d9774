// Protects the judge: what a case's checks say of given runs. The runs are made up, so that every
// answer is known; no engine takes part.
#include "reference/judge/evaluate.hpp"

#include "cases/catalog/case.hpp"

#include <boost/test/unit_test.hpp>

#include <filesystem>

using namespace crossgrain;
using catalog::Check;
using catalog::CheckKind;
using catalog::Reference;
using compare::Outcome;
using judge::CaseRuns;
using judge::Evaluation;

namespace {

/// A small case with the checks of a test instead of its own.
catalog::Case case_with(std::vector<Check> checks, const std::string& name = "small-gas") {
    auto result = catalog::load_case(CROSSGRAIN_SOURCE_DIR "/tests/app/cases/" + name + ".toml",
                                     catalog::Suite::full);
    result.checks = std::move(checks);
    return result;
}

store::RunRecord run_of(const std::string& code, double value, double standard_error,
                        store::RunStatus status = store::RunStatus::ok) {
    store::RunRecord record{.case_name = "small-gas", .code = code, .seed = 1, .status = status};
    if (status != store::RunStatus::ok) {
        record.reason = "reason of " + code;
        return record;
    }
    record.results.measurements.push_back(
        {.observable = "slope", .value = value, .standard_error = standard_error, .n = 20});
    record.results.snapshots.push_back({.time = 0.5, .x = {1.0, value}, .y = {2.0, 3.0}});
    return record;
}

Check check_of(CheckKind kind, double limit) {
    Check check;
    check.kind = kind;
    check.observable = "slope";
    check.limit = limit;
    check.reason = "a test";
    return check;
}

const published::PublishedValues& literature() {
    static const published::PublishedValues values(CROSSGRAIN_SOURCE_DIR "/reference/published");
    return values;
}

judge::Evaluation evaluation_of(const catalog::Case& the_case, std::vector<store::RunRecord> runs) {
    return judge::evaluate(judge::CaseRuns(the_case, std::move(runs)), literature());
}

}  // namespace

BOOST_AUTO_TEST_CASE(parity_rejects_a_difference_above_its_limit) {
    const auto the_case = case_with({check_of(CheckKind::parity, 1e-6)});
    const auto same = evaluation_of(the_case, {run_of("a", 1, 0), run_of("b", 1 + 1e-7, 0)});
    BOOST_REQUIRE(same.verdicts.size() == 1);
    BOOST_CHECK(same.verdicts[0].outcome == Outcome::agree);
    const auto differ = evaluation_of(the_case, {run_of("a", 1, 0), run_of("b", 1 + 1e-5, 0)});
    BOOST_CHECK(differ.verdicts[0].outcome == Outcome::disagree);
    BOOST_TEST(!differ.verdicts[0].expected);
}

BOOST_AUTO_TEST_CASE(equivalence_is_undecided_without_enough_data) {
    const auto the_case = case_with({check_of(CheckKind::agree, 0.3)});
    const auto outcome = [&](double difference, double error) {
        return evaluation_of(the_case, {run_of("a", 0, error), run_of("b", difference, error)})
            .verdicts.at(0)
            .outcome;
    };
    BOOST_CHECK(outcome(0.05, 0.05) == Outcome::agree);
    BOOST_CHECK(outcome(0.05, 0.5) == Outcome::undecided);
    BOOST_CHECK(outcome(2.0, 0.05) == Outcome::disagree);
}

BOOST_AUTO_TEST_CASE(a_code_without_a_result_is_never_green) {
    const auto the_case =
        case_with({check_of(CheckKind::parity, 1), check_of(CheckKind::agree, 1)});
    for (const auto& [status, outcome] : std::map<store::RunStatus, Outcome>{
             {store::RunStatus::not_installed, Outcome::not_installed},
             {store::RunStatus::not_expressible, Outcome::not_expressible},
             {store::RunStatus::run_failed, Outcome::run_failed},
             {store::RunStatus::timed_out, Outcome::run_failed},
             {store::RunStatus::not_run, Outcome::undecided}}) {
        const auto evaluation =
            evaluation_of(the_case, {run_of("a", 1, 0.01), run_of("b", 0, 0, status)});
        BOOST_TEST(evaluation.verdicts.size() == 2U);
        for (const auto& verdict : evaluation.verdicts) {
            BOOST_CHECK(verdict.outcome == outcome);
            BOOST_TEST(!verdict.expected);
            BOOST_TEST(!verdict.reason.empty());
        }
    }
}

BOOST_AUTO_TEST_CASE(what_was_not_measured_is_undecided) {
    auto check = check_of(CheckKind::exact, 1);
    check.observable = "something else";
    check.against = {Reference::Kind::closed_form, "zero"};
    const auto the_case = case_with({check});
    const auto evaluation = evaluation_of(the_case, {run_of("a", 0, 0)});
    BOOST_CHECK(evaluation.verdicts.at(0).outcome == Outcome::undecided);
}

BOOST_AUTO_TEST_CASE(an_exact_check_compares_with_the_closed_form) {
    auto check = check_of(CheckKind::exact, 1e-3);
    check.against = {Reference::Kind::closed_form, "zero"};
    const auto the_case = case_with({check});
    BOOST_CHECK(evaluation_of(the_case, {run_of("a", 5e-4, 0)}).verdicts[0].outcome ==
                Outcome::agree);
    BOOST_CHECK(evaluation_of(the_case, {run_of("a", -2e-3, 0)}).verdicts[0].outcome ==
                Outcome::disagree);
}

BOOST_AUTO_TEST_CASE(a_missing_reference_is_no_reference) {
    auto exact = check_of(CheckKind::exact, 1);
    exact.against = {Reference::Kind::closed_form, "nothing_of_this_name"};
    auto published = check_of(CheckKind::published, 1);
    published.against = {Reference::Kind::published, "nobody-1900/nothing"};
    const auto the_case = case_with({exact, published});
    for (const auto& verdict : evaluation_of(the_case, {run_of("a", 0, 0)}).verdicts) {
        BOOST_CHECK(verdict.outcome == Outcome::no_reference);
        BOOST_TEST(!verdict.expected);
    }
}

BOOST_AUTO_TEST_CASE(an_expected_disagreement_that_agrees_is_an_error) {
    auto check = check_of(CheckKind::parity, 1e-6);
    check.expect = "disagree";
    check.expect_reason = "another convention";
    const auto the_case = case_with({check});
    const auto differ = evaluation_of(the_case, {run_of("a", 1, 0), run_of("b", 2, 0)});
    BOOST_TEST(differ.verdicts[0].expected);
    const auto same = evaluation_of(the_case, {run_of("a", 1, 0), run_of("b", 1, 0)});
    BOOST_CHECK(same.verdicts[0].outcome == Outcome::agree);
    BOOST_TEST(!same.verdicts[0].expected);
}

BOOST_AUTO_TEST_CASE(the_limit_of_a_pair_is_the_larger_of_its_codes) {
    auto check = check_of(CheckKind::parity, 1e-6);
    check.limit_for = {{"b", 1e-3}};
    const auto the_case = case_with({check});
    const auto evaluation = evaluation_of(
        the_case, {run_of("a", 1, 0), run_of("b", 1 + 1e-4, 0), run_of("c", 1 + 1e-4, 0)});
    BOOST_REQUIRE(evaluation.verdicts.size() == 3U);
    BOOST_CHECK(evaluation.verdicts[0].outcome == Outcome::agree);     // a, b
    BOOST_CHECK(evaluation.verdicts[1].outcome == Outcome::disagree);  // a, c
}

BOOST_AUTO_TEST_CASE(the_certificate_holds_distances_digits_and_the_worst_verdict) {
    auto check = check_of(CheckKind::parity, 1e-6);
    check.observable = "trajectory";
    check.at_contact_times = 5;
    const auto the_case = case_with({check});
    const auto evaluation = evaluation_of(the_case, {run_of("a", 1, 0), run_of("b", 1.5, 0)});
    BOOST_REQUIRE(evaluation.certificate.size() == 1U);
    const auto& pair = evaluation.certificate[0];
    BOOST_TEST(pair.curve_dx.at(0) == 0.5);
    BOOST_TEST(pair.max_dx.empty());  // 5 contact times are no power of ten
    BOOST_CHECK(pair.outcome == Outcome::disagree);
    BOOST_TEST(!pair.expected);
}

BOOST_AUTO_TEST_CASE(two_codes_with_the_same_output_are_doubted) {
    const auto statistics = case_with({check_of(CheckKind::agree, 0.3)});
    const auto same = evaluation_of(statistics, {run_of("a", 0.25, 0.05), run_of("b", 0.25, 0.05)});
    BOOST_CHECK(same.verdicts.at(0).outcome == Outcome::disagree);
    auto check = check_of(CheckKind::parity, 1e-3);
    check.observable = "trajectory";
    check.at_contact_times = 5;
    const auto trajectories = case_with({check});
    // Round-off has grown between a and the others, none at all lies between b and c.
    const auto grown = evaluation_of(
        trajectories, {run_of("a", 1, 0), run_of("b", 1 + 1e-6, 0), run_of("c", 1 + 1e-6, 0)});
    BOOST_CHECK(grown.verdicts.at(0).outcome == Outcome::agree);
    BOOST_CHECK(grown.verdicts.at(2).outcome == Outcome::disagree);
    BOOST_TEST(grown.verdicts.at(2).reason.find("same output") != std::string::npos);
    // Where round-off has not grown, codes may well be the same.
    const auto early = evaluation_of(
        trajectories, {run_of("a", 1, 0), run_of("b", 1 + 1e-12, 0), run_of("c", 1 + 1e-12, 0)});
    BOOST_CHECK(early.verdicts.at(2).outcome == Outcome::agree);
}

// LIGGGHTS is a fork of LAMMPS: in a gas both may have the same bits for good, under a free lid,
// which each moves in its own way, they cannot.
BOOST_AUTO_TEST_CASE(one_family_may_have_the_same_bits_in_a_gas_but_not_under_a_lid) {
    auto check = check_of(CheckKind::parity, 1e-3);
    check.observable = "trajectory";
    check.at_contact_times = 5;
    for (const auto& [name, outcome] : std::map<std::string, Outcome>{
             {"small-gas", Outcome::agree}, {"small-bed", Outcome::disagree}}) {
        const auto the_case = case_with({check}, name);
        const auto of_family = [&](double grown) {
            return evaluation_of(the_case,
                                 {run_of("native-dem", 1, 0), run_of("lammps", 1 + grown, 0),
                                  run_of("liggghts", 1 + grown, 0)})
                .verdicts.at(2);
        };
        BOOST_CHECK(of_family(1e-6).outcome == outcome);
        // Before round-off has grown, nothing can be said in either.
        BOOST_CHECK(of_family(1e-12).outcome == Outcome::agree);
    }
}

BOOST_AUTO_TEST_CASE(an_undecided_verdict_says_how_many_replicas_it_needs) {
    const auto the_case = case_with({check_of(CheckKind::agree, 0.3)});
    const auto unsure = evaluation_of(the_case, {run_of("a", 0, 0.15), run_of("b", 0.1, 0.15)});
    BOOST_REQUIRE(unsure.verdicts.at(0).more_replicas.has_value());
    BOOST_TEST(*unsure.verdicts.at(0).more_replicas > 0);
    const auto sure = evaluation_of(the_case, {run_of("a", 0, 0.02), run_of("b", 0.1, 0.02)});
    BOOST_TEST(!sure.verdicts.at(0).more_replicas.has_value());
}
