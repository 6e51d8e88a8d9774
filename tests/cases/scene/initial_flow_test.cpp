// The states that flow starts from: pairs that slide and spin, a pipe, a hopper. Each has the
// geometry it states and no contacts, whatever its numbers.
#include "cases/scene/initial_state.hpp"
#include "tests/support/scenes.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using scene::Scene;

namespace {

Scene unit_scene() {
    auto s = tests::empty_scene("flow", 1e-3, 1.0);
    s.grains = {.diameter = 1.0, .mass = 1.0};
    s.contact.spins = scene::Spins::on;
    s.contact.damping_acts_on = scene::Damping::normal_only;
    s.contact.friction = scene::Friction{.coefficient = 0.5, .stiffness = 100};
    return s;
}

std::size_t frozen_count(const Scene& s) {
    return static_cast<std::size_t>(
        std::count(s.initial.frozen.begin(), s.initial.frozen.end(), true));
}

Scene pipe(double area_fraction, double spread = 0.05) {
    auto s = unit_scene();
    s.periodic_y = 220.8;
    scene::generate_initial_state(s,
                                  scene::Pipe{.width = 11,
                                              .wall_spacing = 1.6,
                                              .area_fraction = area_fraction,
                                              .velocity_spread = 5,
                                              .fall_speed = 8},
                                  {.spread = spread});
    return s;
}

scene::Hopper hopper_of(double angle) {
    return {.angle = angle, .outlet = 10, .height = 30, .settled_fraction = 0.81};
}

Scene hopper(double angle) {
    auto s = unit_scene();
    scene::generate_initial_state(s, hopper_of(angle), {.spread = 0.2});
    return s;
}

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_touch_at_their_impact_parameter_though_they_slide) {
    auto s = unit_scene();
    const scene::Pairs pairs{.count = 8,
                             .approach_speed = 1,
                             .impact_parameter = 0.3,
                             .tangential_speed = {-2, 5},
                             .spin = {-10, 10},
                             .partner_spin = {3, 3},
                             .partner_size = 0.8};
    scene::generate_initial_state(s, pairs);
    for (std::size_t k = 0; k < 8; ++k) {
        const std::size_t a = 2 * k, b = 2 * k + 1;
        const double t = (3 + (static_cast<double>(k) + 0.5) / 8) * s.dt;
        const double dx = s.initial.x[b] - s.initial.x[a] + (s.initial.vx[b] - s.initial.vx[a]) * t;
        const double dy = s.initial.y[b] - s.initial.y[a] + (s.initial.vy[b] - s.initial.vy[a]) * t;
        BOOST_TEST(dy == 0.3, tt::tolerance(1e-11));
        BOOST_TEST(std::hypot(dx, dy) == 0.9, tt::tolerance(1e-12));
        BOOST_TEST(s.initial.vy[a] - s.initial.vy[b] == -2 + 7.0 * static_cast<double>(k) / 7,
                   tt::tolerance(1e-14));
        BOOST_TEST(s.grains.masses[b] == 0.512, tt::tolerance(1e-14));
        BOOST_TEST(s.initial.omega[b] == 3.0);
    }
    auto parting = pairs;
    parting.tangential_speed = {-4, -4};
    BOOST_CHECK_THROW(scene::generate_initial_state(s, parting), std::invalid_argument);
    BOOST_TEST(s.initial.omega.front() == -10.0);
    BOOST_TEST(s.initial.omega[14] == 10.0);
}

BOOST_AUTO_TEST_CASE(sizes_are_even_within_their_spread_and_masses_follow) {
    const auto s = pipe(0.15);
    double sum = 0;
    const std::size_t mobile = s.grain_count() - frozen_count(s);
    for (std::size_t i = 0; i < mobile; ++i) {
        const double ratio = s.grains.diameters[i];
        BOOST_TEST((ratio > 0.95 && ratio < 1.05));
        BOOST_TEST(s.grains.masses[i] == ratio * ratio * ratio, tt::tolerance(1e-14));
        sum += ratio;
    }
    // Standard error of the mean of 422 numbers even in +-0.05: 0.0014.
    BOOST_TEST(std::abs(sum / static_cast<double>(mobile) - 1) < 0.006);
    for (std::size_t i = mobile; i < s.grain_count(); ++i)
        BOOST_TEST(s.grains.diameters[i] == 1.0);
    BOOST_TEST(!pipe(0.15, 0).grains.differ());
}

BOOST_AUTO_TEST_CASE(a_pipe_has_staggered_walls_and_the_number_of_grains_it_says) {
    const auto s = pipe(0.15);
    BOOST_TEST(frozen_count(s) == 2 * 138u);
    // phi 10 x 220.8 / (pi/4)
    BOOST_TEST(s.grain_count() - frozen_count(s) == 422u);
    const std::size_t first = 422;
    BOOST_TEST(s.initial.x[first] == 0.0);
    BOOST_TEST(s.initial.y[first + 1] - s.initial.y[first] == 1.6, tt::tolerance(1e-13));
    BOOST_TEST(s.initial.x[first + 138] == 11.0);
    BOOST_TEST(s.initial.y[first + 138] == 0.8, tt::tolerance(1e-13));
    double fall = 0;
    for (std::size_t i = 0; i < first; ++i)
        fall -= s.initial.vy[i] / 422;
    BOOST_TEST(fall == 8.0, tt::tolerance(1e-12));
    for (const double phi : {0.02, 0.05, 0.1, 0.2, 0.25, 0.3})
        BOOST_TEST(scene::initial_contacts(pipe(phi)) == 0u);
    BOOST_CHECK_THROW((void)pipe(0.8), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_hopper_opens_by_half_its_angle_on_either_side) {
    for (const double angle : {0.0, 10.0, 30.0, 60.0, 90.0, 120.0}) {
        const auto s = hopper(angle);
        const double slope = std::tan(angle / 2 * std::numbers::pi / 180);
        const double area = (10 + 30 * slope) * 30;
        const std::size_t mobile = s.grain_count() - frozen_count(s);
        const double filling = area * 0.81 / (std::numbers::pi / 4);
        BOOST_TEST(std::abs(static_cast<double>(mobile) - filling) <= 0.5);
        double lowest_right = 0, top_of_wall = 0;
        for (std::size_t i = mobile; i < s.grain_count(); ++i) {
            const double x = std::abs(s.initial.x[i]), y = s.initial.y[i];
            if (x < 5.5 - 1e-9) {  // the plug
                BOOST_TEST(y == 0.0);
                continue;
            }
            BOOST_TEST(std::abs(x - 5.5 - y * slope) < 1e-11);
            if (y == 0) lowest_right = x;
            top_of_wall = std::max(top_of_wall, y);
        }
        BOOST_TEST(lowest_right == 5.5);
        BOOST_TEST(top_of_wall >
                   *std::max_element(s.initial.y.begin(),
                                     s.initial.y.begin() + static_cast<std::ptrdiff_t>(mobile)));
    }
}

BOOST_AUTO_TEST_CASE(a_plug_leaves_no_gap_that_a_grain_could_pass) {
    const auto s = hopper(40);
    std::vector<double> floor;
    for (std::size_t i = 0; i < s.grain_count(); ++i) {
        if (s.initial.frozen[i] && s.initial.y[i] == 0) floor.push_back(s.initial.x[i]);
    }
    std::sort(floor.begin(), floor.end());
    BOOST_TEST(floor.front() == -5.5);
    BOOST_TEST(floor.back() == 5.5);
    for (std::size_t i = 1; i < floor.size(); ++i)
        BOOST_TEST(floor[i] - floor[i - 1] <= 1.0 + 1e-12);
}

BOOST_AUTO_TEST_CASE(a_settled_hopper_is_prepared_by_the_run_without_its_plug) {
    auto s = unit_scene();
    scene::generate_initial_state(s, scene::Settled{.hopper = hopper_of(60), .settle_time = 20},
                                  {.spread = 0.2});
    BOOST_TEST_REQUIRE(s.preparation.has_value());
    BOOST_TEST(s.preparation->steps == 20000);
    std::size_t removed = 0;
    for (std::size_t i = 0; i < s.grain_count(); ++i) {
        if (!s.preparation->removed[i]) continue;
        ++removed;
        BOOST_TEST(s.initial.frozen[i]);
        BOOST_TEST(std::abs(s.initial.x[i]) < 5.0);
    }
    BOOST_TEST(removed == 10u);
}
