// Patterns with a known answer: random orientations have none and no velocity, bands and patches
// are told apart, a shifted copy has the known velocity and sign, a one-sided crater the known
// asymmetry.
#include "cases/measure/hopper/hopper_pattern.hpp"

#include "tests/cases/measure/hopper_frames.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr int replicas = 4;

scene::HopperAutomaton small_hopper() {
    return hopper_scene(20, 500, 36.87, replicas, 100, 10);
}

/// Orientation at (column, half-level, iteration, replica).
using Pattern = std::function<std::uint8_t(std::int64_t, std::int64_t, std::int64_t, int)>;

measure::Results run(const Pattern& pattern, const scene::HopperAutomaton& scene = small_hopper()) {
    measure::HopperPattern estimator(scene, {.window = 50});
    for (int r = 0; r < scene.replicas; ++r) {
        for (std::int64_t i = 0; i <= scene.iterations; i += scene.every) {
            const HopperFilling filling(scene, [&](auto c, auto k) { return pattern(c, k, i, r); });
            estimator.add(filling.view(scene, r, i));
        }
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((-a + b - 1) / b);
}

/// Random orientations in blocks of `columns` by `half_levels`.
std::uint8_t block(std::int64_t c, std::int64_t k, std::int64_t columns, std::int64_t half_levels,
                   int replica) {
    return random_orientation(10U + static_cast<std::uint64_t>(replica), floor_div(c, columns),
                              floor_div(k, half_levels));
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_orientations_have_no_pattern_and_no_velocity) {
    const auto results = run([](auto c, auto k, auto iteration, int r) {
        return random_orientation(static_cast<std::uint64_t>(1000 * r + iteration), c, k);
    });
    const auto g = get(results, "neighbour_correlation");
    BOOST_TEST(std::abs(g.value) < 0.02);
    BOOST_TEST(std::abs(g.value) < 5 * g.standard_error);
    BOOST_TEST(get(results, "vertical_fraction").value == 1.0 / 3, tt::tolerance(0.03));
    // G falls from 1 to 0 within the first separation: (1 - 1/e) of sqrt(3) and of 1.
    BOOST_TEST(get(results, "correlation_length_x").value == 0.632 * std::sqrt(3.0),
               tt::tolerance(0.03));
    BOOST_TEST(get(results, "correlation_length_y").value == 0.632, tt::tolerance(0.03));
    BOOST_TEST(!find(results, "pattern_velocity"));
    BOOST_TEST(state_found(results) == "structureless");
}

BOOST_AUTO_TEST_CASE(random_orientations_that_move_along_are_no_pattern_either) {
    const auto results = run([](auto c, auto k, auto iteration, int r) {
        return random_orientation(static_cast<std::uint64_t>(r), c, k + iteration);
    });
    BOOST_TEST(!find(results, "pattern_velocity"));
    BOOST_TEST(state_found(results) == "structureless");
}

BOOST_AUTO_TEST_CASE(a_shifted_copy_has_the_known_velocity_and_sign) {
    // Two spacings in ten iterations are four half-levels.
    for (const int sign : {-1, 1}) {
        const auto results = run([sign](auto c, auto k, auto iteration, int r) {
            return block(c, k - sign * 4 * (iteration / 10), 20, 8, r);
        });
        const auto v = get(results, "pattern_velocity");
        BOOST_TEST(v.value == sign * 0.2, tt::tolerance(0.02));
        BOOST_TEST(v.unit == "spacings per iteration");
        BOOST_TEST(get(results, "rising_share").value == (sign > 0 ? 1.0 : 0.0));
        BOOST_TEST(get(results, "pattern_velocity_vertical").value == sign * 0.2,
                   tt::tolerance(0.05));
        BOOST_TEST(get(results, "pattern_velocity_slanted").value == sign * 0.2,
                   tt::tolerance(0.05));
    }
    const auto still = run([](auto c, auto k, auto, int r) { return block(c, k, 20, 8, r); });
    BOOST_TEST(std::abs(get(still, "pattern_velocity").value) < 0.01);
}

BOOST_AUTO_TEST_CASE(vertical_and_slanted_grains_may_move_in_opposite_directions) {
    // Vertical grains on even columns' blocks drift up, the two others on odd ones down.
    const auto results = run([](auto c, auto k, auto iteration, int r) {
        const std::int64_t shift = 2 * (iteration / 10);
        const bool rising = floor_div(c, 10) % 2 == 0;
        const auto o = block(c, rising ? k - shift : k + shift, 10, 8, r);
        if (rising) return o == 2 ? std::uint8_t{2} : std::uint8_t{1};
        return o == 2 ? std::uint8_t{3} : std::uint8_t{1};
    });
    BOOST_TEST(get(results, "pattern_velocity_vertical").value > 0.05);
    BOOST_TEST(get(results, "pattern_velocity_slanted").value < 0.05);
}

BOOST_AUTO_TEST_CASE(bands_and_patches_are_told_apart_and_have_their_lengths) {
    // Blocks of b columns: G falls linearly from 1 at 0 to 0 at b column spacings.
    const auto bands = run([](auto c, auto k, auto, int r) { return block(c, k, 20, 8, r); });
    BOOST_TEST(get(bands, "correlation_length_x").value == 0.632 * 20 * std::sqrt(3.0) / 2,
               tt::tolerance(0.25));
    BOOST_TEST(get(bands, "correlation_length_y").value == 0.632 * 4, tt::tolerance(0.1));
    BOOST_TEST(state_found(bands) == "bands");
    BOOST_TEST(get(bands, "horizontal_share").value == 1.0);
    const auto patches = run([](auto c, auto k, auto, int r) { return block(c, k, 8, 60, r); });
    BOOST_TEST(get(patches, "correlation_length_y").value == 0.632 * 30, tt::tolerance(0.25));
    BOOST_TEST(state_found(patches) == "patches");
    BOOST_TEST(get(patches, "horizontal_share").value == 0.0);
}

BOOST_AUTO_TEST_CASE(a_box_of_one_orientation_has_no_length_but_is_a_patch) {
    const auto all = run([](auto, auto, auto, int) { return std::uint8_t{3}; });
    BOOST_TEST(!find(all, "correlation_length_y"));
    BOOST_TEST(!find(all, "pattern_velocity"));
    BOOST_TEST(get(all, "vertical_fraction").value == 0.0);
    BOOST_TEST(state_found(all) == "patches");
    const auto one = run([](auto c, auto k, auto, int r) {
        return r == 0 ? std::uint8_t{3} : block(c, k, 8, 60, r);
    });
    const auto length = get(one, "correlation_length_y");
    BOOST_TEST(length.n == 3U);
    BOOST_TEST(length.settings.at("uniform") == 1.0);
}

BOOST_AUTO_TEST_CASE(an_empty_box_tells_nothing) {
    const auto results =
        run([](auto, auto k, auto, int) { return k > 100 ? std::uint8_t{0} : std::uint8_t{1}; });
    BOOST_TEST(!find(results, "neighbour_correlation"));
    BOOST_TEST(state_found(results).empty());
}

BOOST_AUTO_TEST_CASE(unequal_fractions_alone_are_no_correlation) {
    const auto results = run([](auto c, auto k, auto iteration, int r) {
        const auto o = random_orientation(static_cast<std::uint64_t>(1000 * r + iteration), c, k);
        return o == 2 && (c + k) % 8 != 0 ? std::uint8_t{1} : o;
    });
    BOOST_TEST(get(results, "vertical_fraction").value < 0.2);
    BOOST_TEST(std::abs(get(results, "neighbour_correlation").value) < 0.05);
}

BOOST_AUTO_TEST_CASE(a_crater_on_one_side_is_asymmetric) {
    const auto crater = [](std::int64_t right_edge) {
        return [right_edge](std::int64_t c, std::int64_t k, std::int64_t, int r) {
            if (k >= 480 && c >= -40 && c <= right_edge) return std::uint8_t{0};
            return block(c, k, 20, 8, r);
        };
    };
    const auto level = run(crater(40));
    BOOST_TEST(get(level, "asymmetry").value == 0.0);
    BOOST_TEST(state_found(level) == "bands");
    // 40 columns on one side, 100 on the other.
    const auto tilted = run(crater(100));
    BOOST_TEST(get(tilted, "asymmetry").value == 60.0 / 140, tt::tolerance(0.02));
    BOOST_TEST(get(tilted, "mirror_imbalance_sites").value == -60.0 / 140, tt::tolerance(0.02));
    BOOST_TEST(state_found(tilted) == "asymmetric");
}

BOOST_AUTO_TEST_CASE(sides_are_told_apart_and_even_out_over_mirror_images) {
    // Three of four slanted grains of one kind, in replicas 0 and 2 of the other.
    const auto lopsided = [](std::uint8_t most, auto c, auto k) {
        const auto rest = static_cast<std::uint8_t>(4 - most);
        return (c + 2 * k) % 4 == 0 ? rest : most;
    };
    const auto one =
        run([&](auto c, auto k, auto, int) { return lopsided(std::uint8_t{1}, c, k); });
    BOOST_TEST(get(one, "mirror_imbalance_grains").value > 0.3);
    const auto both = run([&](auto c, auto k, auto, int r) {
        return lopsided(r % 2 == 0 ? std::uint8_t{1} : std::uint8_t{3}, c, k);
    });
    BOOST_TEST(std::abs(get(both, "mirror_imbalance_grains").value) < 1e-12);
    BOOST_TEST(get(both, "mirror_imbalance_grains").standard_error > 0.1);
}

BOOST_AUTO_TEST_CASE(beyond_120_degrees_the_state_is_left_to_others) {
    auto scene = hopper_scene(20, 450, 125, replicas, 10, 10);
    const auto results =
        run([](auto c, auto k, auto, int r) { return block(c, k, 20, 8, r); }, scene);
    BOOST_TEST(state_found(results).empty());
}

BOOST_AUTO_TEST_CASE(what_cannot_be_measured_is_refused) {
    auto scene = small_hopper();
    using measure::HopperPattern;
    BOOST_CHECK_THROW(HopperPattern(scene, {.lag = 15}), std::invalid_argument);
    BOOST_CHECK_THROW(HopperPattern(scene, {.lag = 200}), std::invalid_argument);
    BOOST_CHECK_THROW(HopperPattern(scene, {.from = 250, .to = 300}), std::invalid_argument);
    BOOST_CHECK_THROW(HopperPattern(scene, {.from = 50, .to = 40}), std::invalid_argument);
    scene.angles = {20, 30};
    BOOST_CHECK_THROW(HopperPattern{scene}, std::invalid_argument);
}
