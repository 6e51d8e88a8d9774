// Results become JSON and come back bit for bit; anything else is refused.
#include "adapters/run/store/packed_bytes.hpp"
#include "adapters/run/store/results_json.hpp"
#include "tests/adapters/run/store/stored_run.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>
#include <vector>

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
    other = results;
    other.pictures[0].pixels[5] = 254;
    BOOST_TEST(!tests::same_bits(results, other));
    other = results;
    other.findings[1].detail = " ";
    BOOST_TEST(!tests::same_bits(results, other));
}

BOOST_AUTO_TEST_CASE(no_results_are_results) {
    const auto back = store::results_from_json(store::to_json({}));
    BOOST_TEST(back.measurements.empty());
    BOOST_TEST(back.series.empty());
    BOOST_TEST(back.snapshots.empty());
    BOOST_TEST(back.pictures.empty());
    BOOST_TEST(back.findings.empty());
}

BOOST_AUTO_TEST_CASE(results_of_a_program_without_pictures_and_findings_are_read) {
    auto results = tests::stored_run().results;
    json document = store::to_json(results);
    document.erase("pictures");
    document.erase("findings");
    results.pictures.clear();
    results.findings.clear();
    BOOST_TEST(tests::same_bits(results, store::results_from_json(document)));
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

BOOST_AUTO_TEST_CASE(damaged_pixels_are_refused) {
    const json picture = store::picture_to_json(tests::stored_run().results.pictures[0]);
    const auto with = [&](const char* key, const json& value) {
        json damaged = picture;
        damaged[key] = value;
        return damaged;
    };
    const std::string pixels = picture["pixels"];
    std::string flipped = pixels;
    flipped[10] = flipped[10] == 'A' ? 'B' : 'A';
    for (const json& damaged : {with("pixels", ""), with("pixels", "*" + pixels.substr(1)),
                                with("pixels", flipped), with("pixels", pixels.substr(4)),
                                with("width", 4), with("height", 1), with("width", 40000)}) {
        BOOST_CHECK_THROW((void)store::picture_from_json(damaged), std::invalid_argument);
    }
    for (const json& damaged : {with("pixels", 3), with("palette", "grey"), with("width", "3")})
        BOOST_CHECK_THROW((void)store::picture_from_json(damaged), json::exception);
}

BOOST_AUTO_TEST_CASE(bytes_are_packed_compactly) {
    for (const std::size_t size : {0UL, 1UL, 2UL, 3UL, 4UL, 1000UL}) {
        std::vector<std::uint8_t> bytes(size);
        for (std::size_t i = 0; i < size; ++i)
            bytes[i] = static_cast<std::uint8_t>(i * i + 7);
        BOOST_TEST(store::unpack(store::pack(bytes), size) == bytes,
                   boost::test_tools::per_element());
    }
    BOOST_TEST(store::pack(std::vector<std::uint8_t>(100'000, 3)).size() < 1000);
    BOOST_CHECK_THROW((void)store::unpack(store::pack({1, 2, 3}), 2), std::invalid_argument);
    BOOST_CHECK_THROW((void)store::unpack(store::pack({1, 2, 3}), 4), std::invalid_argument);
}
