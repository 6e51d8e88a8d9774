// Pictures show each site in its colour at its place, within the size that was asked for.
#include "cases/measure/hopper/hopper_picture.hpp"

#include "tests/cases/measure/hopper_frames.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <stdexcept>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr std::uint8_t outside = 4, surface = 5;

/// Orientation 1 on the left, 3 on the right, 2 in the middle column; emptied above level 80.
measure::Results run(std::int64_t largest, std::vector<std::int64_t> at) {
    const auto scene = hopper_scene(20, 100, 36.87, 2, 10, 5);
    measure::HopperPicture estimator(scene, {.at = std::move(at), .largest = largest});
    for (int r = 0; r < 2; ++r) {
        for (const std::int64_t i : {0, 5, 10}) {
            const HopperFilling filling(scene, [](auto c, auto k) -> std::uint8_t {
                if (k > 80) return 0;
                return c < 0 ? 1 : c > 0 ? 3 : 2;
            });
            estimator.add(filling.view(scene, r, i));
        }
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

std::uint8_t pixel(const measure::Picture& p, double across, double down) {
    const auto column = static_cast<std::size_t>(across * static_cast<double>(p.width));
    const auto row = static_cast<std::size_t>(down * static_cast<double>(p.height));
    return p.pixels[row * p.width + column];
}

}  // namespace

BOOST_AUTO_TEST_CASE(sites_have_their_colour_at_their_place) {
    const auto results = run(400, {0, 10});
    BOOST_TEST_REQUIRE(results.pictures.size() == 2U);  // of the first replica only
    const auto& p = results.pictures[1];
    BOOST_TEST(p.name == "orientation-10");
    BOOST_TEST(p.pixels.size() == p.width * p.height);
    BOOST_TEST(std::max(p.width, p.height) == 400U);
    BOOST_TEST(std::ranges::max(p.pixels) < p.palette.size());
    BOOST_TEST(pixel(p, 0.02, 0.95) == outside);  // beside the outlet
    BOOST_TEST(pixel(p, 0.98, 0.95) == outside);
    BOOST_TEST(pixel(p, 0.35, 0.6) == 1);
    BOOST_TEST(pixel(p, 0.65, 0.6) == 3);
    BOOST_TEST(pixel(p, 0.35, 0.1) == 0);  // emptied
    // The surface is drawn in the row of level 80, at a fifth from the top.
    const auto row = static_cast<std::size_t>(0.2 * static_cast<double>(p.height));
    const auto line = [&](std::size_t r) {
        return std::count(p.pixels.begin() + static_cast<std::ptrdiff_t>(r * p.width),
                          p.pixels.begin() + static_cast<std::ptrdiff_t>((r + 1) * p.width),
                          surface);
    };
    BOOST_TEST(line(row) > static_cast<std::ptrdiff_t>(p.width / 4));
    BOOST_TEST(line(p.height / 2) == 0);
}

BOOST_AUTO_TEST_CASE(the_last_frame_is_drawn_if_nothing_is_said) {
    const auto results = run(64, {});
    BOOST_TEST_REQUIRE(results.pictures.size() == 1U);
    BOOST_TEST(results.pictures[0].name == "orientation-10");
    BOOST_TEST(std::max(results.pictures[0].width, results.pictures[0].height) == 64U);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_drawn_is_refused) {
    const auto scene = hopper_scene(20, 100, 36.87, 2, 10, 5);
    BOOST_CHECK_THROW(measure::HopperPicture(scene, {.at = {7}}), std::invalid_argument);
    BOOST_CHECK_THROW(measure::HopperPicture(scene, {.largest = 4}), std::invalid_argument);
}
