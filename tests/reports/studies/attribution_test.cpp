// Protects the attribution of differences between codes to their conventions of friction: made-up
// runs of the shipped case, in which every switch has a known effect.
#include "reports/studies/attribution.hpp"

#include "cases/catalog/case.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::studies;

namespace {

std::shared_ptr<const catalog::Case> case_of(const std::string& name) {
    return std::make_shared<const catalog::Case>(
        catalog::find_case(CROSSGRAIN_SOURCE_DIR "/cases/catalog", name, catalog::Suite::full));
}

/// Temperature 10, + 0.5 with the limit of the spring alone, - 0.2 with the radius as the lever of
/// the velocity; replicas differ alike in all variants.
double temperature(const catalog::Variant& variant, std::int64_t replica) {
    const double limit = variant.parameter("limit") == "spring-only" ? 0.5 : 0;
    const double lever = variant.parameter("velocity_lever") == "radius" ? -0.2 : 0;
    return 10 + limit + lever + 0.01 * static_cast<double>(replica);
}

std::vector<store::RunRecord> runs_of(const catalog::Case& the_case, std::int64_t replicas) {
    std::vector<store::RunRecord> records;
    for (const auto& variant : the_case.variants) {
        for (std::int64_t replica = 0; replica < replicas; ++replica) {
            store::RunRecord record{.case_name = the_case.name,
                                    .variant = variant.name,
                                    .code = "native-dem",
                                    .replica = replica,
                                    .status = store::RunStatus::ok};
            record.results.measurements.push_back({.observable = "granular_temperature",
                                                   .value = temperature(variant, replica),
                                                   .unit = "l^2/t^2"});
            records.push_back(std::move(record));
        }
    }
    return records;
}

session::SessionReport report_of(const std::shared_ptr<const catalog::Case>& the_case,
                                 std::vector<store::RunRecord> records) {
    session::SessionReport report;
    report.cases.push_back({the_case, judge::CaseRuns(*the_case, std::move(records)), {}});
    return report;
}

const studies::AttributedPair& pair_of(const std::vector<studies::AttributedPair>& pairs,
                                       const std::string& a, const std::string& b) {
    const auto found =
        std::ranges::find_if(pairs, [&](const auto& pair) { return pair.a == a && pair.b == b; });
    BOOST_TEST_REQUIRE((found != pairs.end()), a << ", " << b);
    return *found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_pair_of_codes_differs_by_what_its_switches_make) {
    const auto the_case = case_of("attribution-friction");
    const auto report = report_of(the_case, runs_of(*the_case, 4));
    const auto pairs = studies::attribute_conventions(report.cases[0].runs);
    BOOST_TEST(pairs.size() == 6U);
    const auto& pair = pair_of(pairs, "lammps-granular", "liggghts");
    BOOST_TEST_REQUIRE(pair.switches.size() == 3U);
    BOOST_TEST(pair.switches[0].key == "velocity_lever");
    BOOST_TEST(pair.switches[0].from == "radius");
    BOOST_TEST(pair.switches[0].to == "contact-point");
    BOOST_TEST(pair.switches[1].key == "rotation");
    BOOST_TEST(pair.switches[2].key == "limit");
    BOOST_TEST_REQUIRE(pair.observables.size() == 1U);
    const auto& found = pair.observables[0].attribution;
    BOOST_TEST(found.difference.value == 0.7, tt::tolerance(1e-12));
    BOOST_TEST(found.contributions[0].average.value == 0.2, tt::tolerance(1e-12));
    BOOST_TEST(std::abs(found.contributions[1].average.value) < 1e-12);
    BOOST_TEST(found.contributions[2].average.value == 0.5, tt::tolerance(1e-12));
    const auto& alike = pair_of(pairs, "liggghts", "yade");
    BOOST_TEST(alike.switches.size() == 1U);
    BOOST_TEST(std::abs(alike.observables[0].attribution.difference.value) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_missing_combination_is_never_made_up) {
    const auto the_case = case_of("attribution-friction");
    auto records = runs_of(*the_case, 5);
    const auto failed = std::ranges::find_if(records, [](const auto& record) {
        return record.variant == "radius/radius/project/spring-only" && record.replica == 2;
    });
    BOOST_TEST_REQUIRE((failed != records.end()));
    failed->status = store::RunStatus::run_failed;
    const auto all_but_one = studies::attribute_conventions(judge::CaseRuns(*the_case, records));
    const auto& through = pair_of(all_but_one, "lammps-hooke-history", "liggghts");
    BOOST_TEST(through.observables[0].attribution.difference.n == 4U);  // that replica is left out
    const auto& beside = pair_of(all_but_one, "lammps-granular", "liggghts");
    BOOST_TEST(beside.observables[0].attribution.difference.n == 5U);
    std::erase_if(records, [](const auto& record) {
        return record.variant == "radius/radius/project/spring-only";
    });
    const auto pairs = studies::attribute_conventions(judge::CaseRuns(*the_case, records));
    BOOST_TEST(pairs.size() == 4U);  // without the two of lammps-hooke-history through it
    BOOST_CHECK(studies::attribute_conventions(judge::CaseRuns(*the_case, {})).empty());
}

BOOST_AUTO_TEST_CASE(three_replicas_are_too_few_and_it_says_so) {
    const auto the_case = case_of("attribution-friction");
    const auto report = report_of(the_case, runs_of(*the_case, 3));
    BOOST_CHECK(studies::attribute_conventions(report.cases[0].runs).empty());
    const std::string text = studies::attribution_table(report);
    BOOST_TEST((text.find("attribution-friction: no attribution") != std::string::npos), text);
}

BOOST_AUTO_TEST_CASE(a_case_without_a_sweep_of_conventions_has_no_table) {
    const auto the_case = case_of("gas-friction");
    const auto report = report_of(the_case, {});
    BOOST_TEST(studies::attribution_table(report).empty());
    BOOST_TEST(studies::attribution_document(report).empty());
}

BOOST_AUTO_TEST_CASE(says_in_words_and_numbers_what_makes_the_difference) {
    const auto the_case = case_of("attribution-friction");
    const auto report = report_of(the_case, runs_of(*the_case, 4));
    const std::string text = studies::attribution_table(report);
    const std::string sentence = "lammps-granular and liggghts differ by 6.9 +- 0.0 % in granular "
                                 "temperature (liggghts is larger): limit 4.9, velocity lever 2.0, "
                                 "rotation";
    BOOST_TEST((text.find(sentence) != std::string::npos), text);
    const auto document = studies::attribution_document(report);
    BOOST_TEST_REQUIRE(document.size() == 6U);
    const auto& observable = document[0]["observables"][0];
    BOOST_TEST(document[0]["switches"].size() == observable["contributions"].size());
    BOOST_TEST(observable["replicas"] == 4);
    BOOST_TEST(observable["unit"] == "l^2/t^2");
}
