// Twins that differ in a known share of their sites.
#include "cases/measure/hopper/hopper_damage.hpp"

#include "tests/cases/measure/hopper_frames.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

scene::HopperAutomaton twins(int replicas) {
    auto scene = hopper_scene(20, 200, 36.87, replicas, 100, 50);
    scene.flipped = 4;
    return scene;
}

/// The lowest `levels(replica, iteration)` half-levels of the twin are turned.
measure::Results run(int replicas, const std::function<int(int, std::int64_t)>& levels) {
    const auto scene = twins(replicas);
    measure::HopperDamage estimator(scene);
    for (int r = 0; r < replicas; ++r) {
        for (std::int64_t i = 0; i <= 100; i += 50) {
            const auto random = [r](auto c, auto k) {
                return random_orientation(static_cast<std::uint64_t>(r), c, k);
            };
            HopperFilling filling(scene, random);
            filling.twin = filling.states([&](auto c, auto k) {
                const std::uint8_t s = random(c, k);
                return k < levels(r, i) ? static_cast<std::uint8_t>(s % 3 + 1) : s;
            });
            estimator.add(filling.view(scene, r, i));
        }
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(equal_twins_have_no_damage_but_an_error_of_the_share) {
    const auto results = run(20, [](int, auto) { return 0; });
    BOOST_TEST(get(results, "damage").value == 0.0);
    BOOST_TEST(get(results, "shape_difference").value == 0.0);
    const auto share = get(results, "damaged_trials");
    BOOST_TEST(share.value == 0.0);
    // Of 20 trials without damage, one in 22 may still be damaged.
    BOOST_TEST(share.standard_error == std::sqrt(1.0 / 22 * 21 / 22 / 22), tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_share_of_damaged_trials_is_counted) {
    // Ten half-levels of 20 sites or so are 2.5 % of the hopper's 7,900, one is below 1 %.
    const auto results = run(20, [](int r, std::int64_t iteration) {
        return iteration == 0 ? 0 : (r % 4 == 0 ? 10 : 1);
    });
    const auto share = get(results, "damaged_trials");
    BOOST_TEST(share.value == 0.25);
    BOOST_TEST(share.n == 20U);
    BOOST_TEST(share.standard_error == 0.1, tt::tolerance(0.1));  // sqrt(.25 .75/20) = .097
    const double damage = get(results, "damage").value;
    BOOST_TEST(damage > 0.25 * 0.02);
    BOOST_TEST(damage < 0.25 * 0.04 + 0.005);
    BOOST_TEST(column(results, "damage", "damaged_trials") == (std::vector{0.0, 0.25, 0.25}),
               tt::per_element());
}

BOOST_AUTO_TEST_CASE(shapes_differ_by_what_only_one_of_them_has_emptied) {
    const auto scene = twins(2);
    measure::HopperDamage estimator(scene);
    for (int r = 0; r < 2; ++r) {
        const auto crater = [](std::int64_t floor) {
            return [floor](std::int64_t c, std::int64_t k) {
                return k >= floor && std::abs(c) <= 20 ? std::uint8_t{0} : std::uint8_t{1};
            };
        };
        HopperFilling filling(scene, crater(100));
        filling.twin = filling.states(crater(150));
        estimator.add(filling.view(scene, r, 100));
    }
    measure::Results results;
    estimator.finish(results);
    // 50 of 100 emptied half-levels are emptied in one only.
    BOOST_TEST(get(results, "shape_difference").value == 0.5, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_scene_without_a_twin_is_refused) {
    auto scene = twins(2);
    scene.flipped = 0;
    BOOST_CHECK_THROW(measure::HopperDamage{scene}, std::invalid_argument);
}
