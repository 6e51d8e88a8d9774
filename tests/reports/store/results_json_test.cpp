// Results become JSON and come back bit for bit; anything else is refused.
#include "reports/store/results_json.hpp"
#include "tests/reports/store/stored_run.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <string>

using namespace crossgrain;
using nlohmann::json;

BOOST_AUTO_TEST_CASE(results_come_back_bit_for_bit_from_text_and_from_bytes) {
    const auto results = tests::stored_run().results;
    const json document = store::to_json(results);
    BOOST_TEST(tests::same_bits(results, store::results_from_json(document)));
    BOOST_TEST(tests::same_bits(results, store::results_from_json(json::parse(document.dump()))));
    BOOST_TEST(tests::same_bits(
        results, store::results_from_json(json::from_cbor(json::to_cbor(document)))));
}

BOOST_AUTO_TEST_CASE(the_comparison_of_these_tests_sees_a_single_bit) {
    const auto results = tests::stored_run().results;
    auto other = results;
    other.snapshots[0].y[1] = 0.0;  // instead of -0
    BOOST_TEST(!tests::same_bits(results, other));
    other = results;
    other.series[0].values[1][4] = 0.0;  // instead of the smallest number
    BOOST_TEST(!tests::same_bits(results, other));
    other = results;
    other.measurements[0].systematic = 0;
    BOOST_TEST(!tests::same_bits(results, other));
}

BOOST_AUTO_TEST_CASE(no_results_are_results) {
    const auto back = store::results_from_json(store::to_json({}));
    BOOST_TEST(back.measurements.empty());
    BOOST_TEST(back.series.empty());
    BOOST_TEST(back.snapshots.empty());
}

BOOST_AUTO_TEST_CASE(a_document_of_another_kind_is_refused) {
    for (
        const std::string text :
        {"{}", "[]", "3", R"({"measurements": [], "series": []})",
         R"({"measurements": [{"value": 1}], "series": [], "snapshots": []})",
         R"({"measurements": [], "series": [], "snapshots": [{"time": "t", "x": [], "y": []}]})"}) {
        BOOST_CHECK_THROW((void)store::results_from_json(json::parse(text)), json::exception);
    }
}
