// A file that somebody damaged or made on purpose cannot overrun the stack.
#include "native/base/bounded_json.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>
#include <vector>

using namespace crossgrain;
using nlohmann::json;

namespace {

std::string nested(std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
}

template <class Function>
std::string refusal(Function function) {
    try {
        function();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_we_write_is_read) {
    const json document{{"a", {1, 2.5, "text", nullptr, true}}, {"b", {{"c", json::array()}}}};
    BOOST_TEST((bounded_json(document.dump()) == document));
    BOOST_TEST((bounded_cbor(json::to_cbor(document)) == document));
}

BOOST_AUTO_TEST_CASE(depth_is_bounded) {
    BOOST_TEST(bounded_json(nested(deepest_json)).is_array());
    BOOST_TEST(refusal([] { (void)bounded_json(nested(deepest_json + 1)); }) ==
               "is nested deeper than 64 levels");
    // 0x81: a list of one element.
    const std::vector<std::uint8_t> deep(1'000'000, 0x81);
    BOOST_TEST(refusal([&] { (void)bounded_cbor(deep); }) == "is nested deeper than 64 levels");
    BOOST_TEST(refusal([] { (void)bounded_json(nested(1'000'000)); }) ==
               "is nested deeper than 64 levels");
}

BOOST_AUTO_TEST_CASE(damage_is_named) {
    BOOST_TEST(refusal([] { (void)bounded_json(""); }).starts_with("is damaged at byte"));
    BOOST_TEST(refusal([] { (void)bounded_json("{\"a\": [1, 2"); }).starts_with("is damaged"));
    auto cut = json::to_cbor(json{{"a", {1, 2, 3}}});
    cut.pop_back();
    BOOST_TEST(refusal([&] { (void)bounded_cbor(cut); }).starts_with("is damaged at byte"));
    // A list that claims 2^60 elements does not allocate them.
    const std::vector<std::uint8_t> boast{0x9b, 0x10, 0, 0, 0, 0, 0, 0, 0, 1};
    BOOST_TEST(refusal([&] { (void)bounded_cbor(boast); }).starts_with("is damaged at byte"));
}
