// Generated states are free of contacts, at rest as a whole, reproducible to the bit, and spread
// the phases of their collisions evenly over a time step.
#include "cases/scene/initial_state.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain::scene;

namespace {

/// Doubly periodic, or with a bottom and a lid that a lattice places.
Scene empty_box(std::uint64_t seed = 1) {
    Scene scene{.name = "box", .grains = {.diameter = 2, .mass = 1}};
    scene.periodic_x = scene.periodic_y = 20;
    scene.dt = 1e-3;
    scene.steps = scene.frame_every = 1000;
    scene.seed = seed;
    return scene;
}

Scene gas(std::uint64_t seed = 1, std::size_t count = 64) {
    auto scene = empty_box(seed);
    generate_initial_state(scene, Gas{.count = count, .velocity_spread = 3});
    return scene;
}

Scene bed(PlateContact touches, std::size_t count = 90) {
    auto scene = empty_box();
    scene.periodic_y.reset();
    scene.plates = {.stiffness = 500,
                    .touches = touches,
                    .bottom = PrescribedPlate{.height = 1, .amplitude = 0.5, .period = 3},
                    .lid = FreeLid{.mass = 10}};
    generate_initial_state(
        scene, Lattice{.count = count, .columns = 9, .velocity_spread = 0.1, .lid_gap = 0.25});
    return scene;
}

Scene open_scene(const InitialStateRecipe& recipe) {
    auto scene = empty_box();
    scene.periodic_x.reset();
    scene.periodic_y.reset();
    generate_initial_state(scene, recipe);
    return scene;
}

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

double standard_deviation(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values)
        squares += value * value;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

bool same_bits(const InitialState& a, const InitialState& b) {
    return a.x == b.x && a.y == b.y && a.vx == b.vx && a.vy == b.vy;
}

/// Fractions of a time step at which pairs or bounces touch, sorted.
std::vector<double> phases(const std::vector<double>& gaps, double speed, double dt) {
    std::vector<double> result;
    for (const double gap : gaps)
        result.push_back(gap / (speed * dt) - std::floor(gap / (speed * dt)));
    std::sort(result.begin(), result.end());
    return result;
}

void check_evenly_spread(const std::vector<double>& sorted) {
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        const double expected = (static_cast<double>(k) + 0.5) / static_cast<double>(sorted.size());
        // Gaps of 1e-3 at positions of order 100 keep eleven digits.
        BOOST_TEST(std::abs(sorted[k] - expected) < 1e-9);
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_gas_has_no_contacts_at_any_density_it_accepts) {
    for (const std::size_t count : {1u, 2u, 50u, 64u, 81u}) {
        for (std::uint64_t seed = 1; seed <= 20; ++seed)
            BOOST_TEST(initial_contacts(gas(seed, count)) == 0u);
    }
    BOOST_CHECK_THROW((void)gas(1, 82), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_gas_is_at_rest_as_a_whole_and_as_hot_as_it_is_told) {
    const auto& s = gas().initial;
    // 64 roundings of numbers of order 3.
    BOOST_TEST(std::abs(sum(s.vx)) < 1e-13);
    BOOST_TEST(std::abs(sum(s.vy)) < 1e-13);
    // 64 samples know a standard deviation to 9 %: five of those.
    BOOST_TEST(standard_deviation(s.vx) == 3.0, tt::tolerance(0.45));
    BOOST_TEST(standard_deviation(s.vy) == 3.0, tt::tolerance(0.45));
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_bits_and_another_seed_does_not) {
    BOOST_TEST(same_bits(gas(5).initial, gas(5).initial));
    const auto a = gas(5).initial, b = gas(6).initial;
    BOOST_TEST(a.x != b.x, tt::per_element());
    BOOST_TEST(a.y != b.y, tt::per_element());
    BOOST_TEST(a.vx != b.vx, tt::per_element());
    BOOST_TEST(a.vy != b.vy, tt::per_element());
}

BOOST_AUTO_TEST_CASE(a_lattice_stands_above_the_bottom_and_below_the_lid_without_contacts) {
    for (const auto touches : {PlateContact::centre, PlateContact::surface}) {
        const auto scene = bed(touches);
        const double reach = touches == PlateContact::surface ? 1 : 0;
        BOOST_TEST(initial_contacts(scene) == 0u);
        const auto [low, high] =
            std::minmax_element(scene.initial.y.begin(), scene.initial.y.end());
        BOOST_TEST(*low - reach > 1.5);  // the bottom starts at height + amplitude
        BOOST_TEST(std::get<FreeLid>(scene.plates.lid).height == *high + reach + 0.25,
                   tt::tolerance(1e-15));
        BOOST_TEST(std::abs(sum(scene.initial.vx)) < 1e-13);
    }
}

BOOST_AUTO_TEST_CASE(a_lattice_is_triangular_with_its_columns_per_row) {
    const auto& s = bed(PlateContact::centre, 27).initial;
    const double spacing = 20.0 / 9;
    for (std::size_t row = 1; row < 3; ++row) {
        // Rows alternate by half a spacing and rise by sqrt(3)/2; the jitter is below 0.1.
        const double rise = s.y[9 * row] - s.y[9 * (row - 1)];
        BOOST_TEST(std::abs(rise - spacing * std::sqrt(3.0) / 2) < 0.21);
        const double side = s.x[9 * row] - s.x[9 * (row - 1)];
        BOOST_TEST(std::abs(std::abs(side) - spacing / 2) < 0.21);
    }
    BOOST_TEST(std::abs(s.x[1] - s.x[0] - spacing) < 0.21);
}

BOOST_AUTO_TEST_CASE(entry_phases_of_pairs_cover_one_time_step_evenly) {
    for (const double b : {0.0, 1.2, -1.9}) {
        const auto scene =
            open_scene(Pairs{.count = 16, .approach_speed = 1.5, .impact_parameter = b});
        const auto& s = scene.initial;
        std::vector<double> gaps;
        for (std::size_t k = 0; k < 16; ++k) {
            BOOST_TEST(s.y[2 * k + 1] - s.y[2 * k] == b, tt::tolerance(1e-13));
            gaps.push_back(s.x[2 * k + 1] - s.x[2 * k] - std::sqrt(4 - b * b));
            BOOST_TEST(gaps.back() > 3 * 1.5e-3);  // three whole steps of free flight
            BOOST_TEST(gaps.back() < 4 * 1.5e-3);
            BOOST_TEST(s.vx[2 * k] == 0.75);
            BOOST_TEST(s.vx[2 * k + 1] == -0.75);
        }
        check_evenly_spread(phases(gaps, 1.5, 1e-3));
        BOOST_TEST(initial_contacts(scene) == 0u);
    }
}

BOOST_AUTO_TEST_CASE(pairs_never_meet_another_pair) {
    const auto scene = open_scene(Pairs{.count = 64, .approach_speed = 2});
    const double reach = 2 * scene.dt * static_cast<double>(scene.steps);  // of one grain, at most
    const auto& s = scene.initial;
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        for (std::size_t j = i + 1; j < s.x.size(); ++j) {
            if (j / 2 == i / 2) continue;
            const double distance = std::hypot(s.x[i] - s.x[j], s.y[i] - s.y[j]);
            // After the collision each grain has at most the approach speed, along x.
            BOOST_TEST_REQUIRE(distance > 2 + reach);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_frozen_partner_waits_at_rest) {
    const auto s =
        open_scene(Pairs{.count = 2, .approach_speed = 1.5, .frozen_partner = true}).initial;
    BOOST_TEST(s.frozen == (std::vector<bool>{false, true, false, true}), tt::per_element());
    for (std::size_t k = 0; k < 2; ++k) {
        BOOST_TEST(s.vx[2 * k] == 1.5);
        BOOST_TEST(s.vx[2 * k + 1] == 0.0);
    }
}

BOOST_AUTO_TEST_CASE(entry_phases_of_bounces_cover_one_time_step_evenly) {
    for (const auto touches : {PlateContact::centre, PlateContact::surface}) {
        auto scene = empty_box();
        scene.periodic_x.reset();
        scene.periodic_y.reset();
        scene.plates = {.stiffness = 500,
                        .touches = touches,
                        .bottom = PrescribedPlate{.height = -3},
                        .lid = {}};
        generate_initial_state(scene, Bounces{.count = 16, .speed = 2});
        std::vector<double> gaps;
        for (std::size_t k = 0; k < 16; ++k) {
            gaps.push_back(scene.initial.y[k] + 3 - (touches == PlateContact::surface ? 1 : 0));
            BOOST_TEST(scene.initial.vy[k] == -2.0);
        }
        check_evenly_spread(phases(gaps, 2, 1e-3));
    }
}

BOOST_AUTO_TEST_CASE(a_bounce_on_the_free_lid_comes_from_below) {
    auto scene = empty_box();
    scene.periodic_y.reset();
    scene.plates = {.stiffness = 500, .touches = PlateContact::surface, .bottom = {}, .lid = {}};
    scene.plates.lid = FreeLid{.mass = 3, .height = 10};
    const Bounces bounce{.count = 1, .speed = 2, .target = Target::lid, .lead_steps = 5};
    generate_initial_state(scene, bounce);
    BOOST_TEST(scene.initial.vy[0] == 2.0);
    BOOST_TEST(scene.initial.y[0] == 10 - 1 - 5.5 * 2e-3, tt::tolerance(1e-14));
}

namespace {

/// A box between plates at rest, `period` wide.
Scene packing(double period, std::size_t count) {
    auto scene = empty_box();
    scene.periodic_y.reset();
    scene.periodic_x = period;
    scene.plates = {.stiffness = 500,
                    .touches = {},
                    .bottom = PrescribedPlate{.height = 1},
                    .lid = PrescribedPlate{.height = 100}};
    generate_initial_state(scene, Packing{.count = count, .velocity_spread = 0.1});
    return scene;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_packing_touches_everywhere_and_overlaps_nowhere) {
    for (const double period : {20.0, 20.0000001}) {
        const auto scene = packing(period, 60);
        BOOST_TEST(initial_contacts(scene) == 0U);
        const auto& s = scene.initial;
        BOOST_TEST(s.y[0] == 1.0);
        BOOST_TEST(s.y[10] - s.y[0] == std::sqrt(3.0), tt::tolerance(1e-7));
        // Six neighbours at the diameter, but for grains of the lowest and the highest row.
        std::size_t bonds = 0;
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double dx = nearest_image(s.x[i] - s.x[j], scene.periodic_x);
                if (std::hypot(dx, s.y[i] - s.y[j]) < 2 * (1 + 1e-7)) ++bonds;
            }
        }
        BOOST_TEST(bonds == 60U + 2 * 50U);  // along the rows, and two up from all but the last
        BOOST_TEST(std::abs(sum(s.vx)) < 1e-14);
    }
}

BOOST_AUTO_TEST_CASE(a_packing_fills_its_rows) {
    BOOST_CHECK_THROW((void)packing(20, 61), std::invalid_argument);
    BOOST_CHECK_THROW((void)packing(19.9, 60), std::invalid_argument);  // nine columns
}
