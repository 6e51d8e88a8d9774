// P(theta) that obeys a known law: exponents, critical angle, errors; and what must give none.
#include "cases/measure/hopper/hopper_stagnation.hpp"

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

/// L is large so that whole half-levels hardly round P.
scene::HopperAutomaton sweep(int replicas, double from = 10, double to = 90, double step = 0.5) {
    auto scene = hopper_scene(20, 1'000'000, from, replicas, 100, 50);
    scene.angles.clear();
    for (int i = 0; from + i * step <= to + 1e-9; ++i)
        scene.angles.push_back(from + i * step);
    return scene;
}

using Law = std::function<double(double theta, int replica, std::int64_t iteration)>;

measure::Results run(const scene::HopperAutomaton& scene, const Law& law,
                     measure::HopperStagnationOptions options = {}) {
    measure::HopperStagnation estimator(scene, std::move(options));
    for (std::size_t a = 0; a < scene.angles.size(); ++a) {
        for (int r = 0; r < scene.replicas; ++r) {
            for (std::int64_t i = 0; i <= scene.iterations; i += scene.every) {
                const double p = law(scene.angles[a], r, i);
                // The walls differ; their mean is P.
                const auto reach = [&](double share) {
                    return static_cast<std::int32_t>(std::lround(share * scene.levels)) - 1;
                };
                estimator.add({.angle_index = a,
                               .angle = scene.angles[a],
                               .replica = r,
                               .iteration = i,
                               .last = i == scene.iterations,
                               .left_reach = reach(0.9 * p),
                               .right_reach = reach(1.1 * p)});
            }
        }
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

double broken_law(double theta, double critical, double a) {
    return std::min(1.0, std::pow(theta / critical, -a));
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_known_power_law_has_its_exponent_in_every_window_of_its_region) {
    const auto results =
        run(sweep(4), [](double theta, int, std::int64_t) { return broken_law(theta, 12.6, 2.3); });
    for (const char* window : {"13_90", "20_90", "30_90"}) {
        for (const char* fit : {"exponent_log_", "exponent_unweighted_"}) {
            const auto m = get(results, std::string(fit) + window);
            BOOST_TEST(m.value == 2.3, tt::tolerance(1e-3));  // P in steps of 1e-6
            BOOST_TEST(m.n == 4U);
        }
    }
    // Mass flow below 13 degrees is no power law: the window that holds it finds less.
    BOOST_TEST(get(results, "exponent_log_10_90").value < 2.29);
    BOOST_TEST(get(results, "critical_angle_fit").value == 12.6, tt::tolerance(1e-3));
    BOOST_TEST(get(results, "moving_fraction").value == 1.0, tt::tolerance(1e-5));
    BOOST_TEST(get(results, "moving_fraction_left").value == 0.9, tt::tolerance(1e-5));
    BOOST_TEST(get(results, "moving_fraction_right").value == 1.1, tt::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(an_exponent_in_the_tangent_is_found_as_such) {
    const auto results = run(sweep(4), [](double theta, int, std::int64_t) {
        const double t = std::tan(theta * std::acos(-1.0) / 360);
        return std::min(1.0, 0.01 / (t * t));
    });
    BOOST_TEST(get(results, "exponent_tan_log_20_90").value == 2.0, tt::tolerance(1e-3));
    BOOST_TEST(get(results, "exponent_tan_unweighted_20_90").value == 2.0, tt::tolerance(1e-3));
    BOOST_TEST(get(results, "exponent_log_20_90").value > 2.1);
}

BOOST_AUTO_TEST_CASE(the_critical_angle_is_where_the_wall_stops_moving) {
    const auto results = run(sweep(4, 10, 90, 0.1), [](double theta, int, std::int64_t) {
        return broken_law(theta, 15, 2.3);
    });
    // P = 0.99 is reached 0.07 degrees later; the average over a degree sees it before.
    const auto m = get(results, "critical_angle");
    BOOST_TEST(std::abs(m.value - 15.0) < 0.2);
    BOOST_TEST(m.systematic > 0);
    BOOST_TEST(m.unit == "degrees");
}

BOOST_AUTO_TEST_CASE(no_critical_angle_without_mass_flow_or_without_its_end) {
    const auto none = run(sweep(4), [](double, int, std::int64_t) { return 0.5; });
    BOOST_TEST(!find(none, "critical_angle"));
    // A P that does not depend on theta is no power law in any useful sense, but has exponent 0.
    BOOST_TEST(std::abs(get(none, "exponent_log_13_90").value) < 1e-9);
    const auto all = run(sweep(4), [](double, int, std::int64_t) { return 1.0; });
    BOOST_TEST(!find(all, "critical_angle"));
    const auto coarse = run(sweep(4, 10, 90, 4), [](double theta, int, std::int64_t) {
        return broken_law(theta, 15, 2.3);
    });
    BOOST_TEST(!find(coarse, "critical_angle"));
}

BOOST_AUTO_TEST_CASE(errors_are_the_scatter_of_replicas_or_a_bootstrap_over_angles) {
    constexpr double spread = 0.15;  // of ln P, as the automaton has it
    const Law noisy = [](double theta, int replica, std::int64_t) {
        const auto n = static_cast<std::uint64_t>(std::lround(theta * 10) * 100 + replica);
        const double noise = normal_pair(7, RandomStream::jitter, n)[0];
        return broken_law(theta, 12.6, 2.3) * std::exp(spread * noise);
    };
    const auto one = get(run(sweep(1), noisy), "exponent_log_20_90");
    const auto many = get(run(sweep(16), noisy), "exponent_log_20_90");
    // Least squares: spread/sqrt(sum (ln theta - mean)^2) for 141 angles.
    double mean = 0, squares = 0, n = 0;
    for (double theta = 20; theta <= 90; theta += 0.5, ++n)
        mean += std::log(theta);
    for (double theta = 20; theta <= 90; theta += 0.5)
        squares += std::pow(std::log(theta) - mean / n, 2);
    const double expected = spread / std::sqrt(squares);
    BOOST_TEST(one.standard_error == expected, tt::tolerance(0.3));
    BOOST_TEST(one.n == 161U);
    BOOST_TEST(many.standard_error == expected / 4, tt::tolerance(0.5));
    BOOST_TEST(many.n == 16U);
    BOOST_TEST(std::abs(one.value - 2.3) < 4 * one.standard_error);
    BOOST_TEST(std::abs(many.value - 2.3) < 4 * many.standard_error);
}

BOOST_AUTO_TEST_CASE(other_iterations_have_names_of_their_own) {
    const auto results = run(sweep(4),
                             [](double theta, int, std::int64_t iteration) {
                                 return broken_law(theta, iteration == 50 ? 12 : 16, 2.3);
                             },
                             {.at = {100, 50}});
    BOOST_TEST(get(results, "critical_angle_fit").value == 16, tt::tolerance(1e-3));
    BOOST_TEST(get(results, "critical_angle_fit_at_50").value == 12, tt::tolerance(1e-3));
    BOOST_TEST(column(results, "stagnation", "iteration").size() == 2 * 161U);
}

BOOST_AUTO_TEST_CASE(a_wall_that_never_moved_leaves_no_exponent) {
    const auto results =
        run(sweep(4), [](double theta, int, std::int64_t) { return theta > 80 ? 0.0 : 0.5; });
    BOOST_TEST(!find(results, "exponent_log_13_90"));
    BOOST_TEST(!find(results, "exponent_unweighted_13_90"));
    const auto narrow =
        run(sweep(4, 10, 60), [](double theta, int, std::int64_t) { return 10 / theta; });
    BOOST_TEST(!find(narrow, "exponent_log_13_90"));  // the window ends at 90
}

BOOST_AUTO_TEST_CASE(beyond_120_degrees_p_has_no_meaning) {
    const auto law = [](double, int, std::int64_t) { return 0.3; };
    auto scene = hopper_scene(20, 1000, 130, 4, 100, 50);
    const auto wide = run(scene, law);
    BOOST_TEST(state_found(wide) == "no meaning");
    BOOST_TEST(!find(wide, "moving_fraction"));
    scene.angles = {120};
    const auto narrow = run(scene, law);
    BOOST_TEST(state_found(narrow).empty());
    BOOST_TEST(get(narrow, "moving_fraction").value == 0.3, tt::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(an_iteration_that_is_no_frame_is_refused) {
    BOOST_CHECK_THROW(measure::HopperStagnation(sweep(1), {.at = {75}}), std::invalid_argument);
    BOOST_CHECK_THROW(measure::HopperStagnation(sweep(1), {.at = {150}}), std::invalid_argument);
}

// Walls reach 0.9 P and 1.1 P with P = 0.5: all have moved up to 0.45, half of them up to 0.55.
BOOST_AUTO_TEST_CASE(the_profile_of_the_wall_is_the_share_that_moved_at_a_height) {
    measure::HopperStagnationOptions options;
    options.profile_at = 60;
    const auto half = [](double, int, std::int64_t) { return 0.5; };
    const auto results = run(sweep(4), half, options);
    const auto moved = column(results, "wall-profile", "moved");
    BOOST_TEST_REQUIRE(moved.size() == 100U);
    BOOST_TEST(column(results, "wall-profile", "height")[44] == 0.45);
    BOOST_TEST(moved[43] == 1.0);
    BOOST_TEST(moved[45] == 0.5);
    BOOST_TEST(moved[55] == 0.0);
    BOOST_TEST(column(results, "wall-profile", "standard_error")[43] == 0.0);
    options.profile_at = 95;
    BOOST_CHECK_THROW(run(sweep(4), half, options), std::invalid_argument);
}
