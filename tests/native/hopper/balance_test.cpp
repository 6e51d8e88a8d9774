// What the automaton conserves, and what leaves it.
#include "tests/native/hopper/hoppers.hpp"

#include <algorithm>
#include <numeric>

using namespace crossgrain;
using namespace crossgrain::tests;
using hopper::EngineKind;

namespace {

std::size_t grains(const std::vector<std::uint8_t>& state) {
    return state.size() - static_cast<std::size_t>(std::count(state.begin(), state.end(), 0));
}

}  // namespace

BOOST_AUTO_TEST_CASE(grains_in_the_hopper_and_grains_that_left_are_all_grains) {
    auto p = small_hopper();
    for (const auto sweep : {hopper::Sweep::bottom_to_top, hopper::Sweep::top_to_bottom}) {
        p.sweep = sweep;
        const auto engine = hopper::make_engine(p, EngineKind::fast);
        const std::size_t all = engine->geometry().sites();
        BOOST_TEST(grains(engine->state()) == all);
        for (int i = 0; i < 100; ++i) {
            engine->advance(1);
            const auto& flow = engine->record().flow;
            const auto gone = std::accumulate(flow.begin(), flow.end(), std::size_t{0});
            BOOST_TEST(grains(engine->state()) + gone == all);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_flow_is_the_outlet_s_width_until_the_crater_reaches_it) {
    // At whatever height of filling; C_D = 0.01, since others end in a central rathole.
    for (const int levels : {100, 200, 400}) {
        auto p = small_hopper();
        p.outlet = 20;
        p.levels = levels;
        const auto engine = hopper::make_engine(p, EngineKind::fast);
        const auto all = static_cast<double>(engine->geometry().sites());
        double left = all;
        while (left > all / 2) {
            engine->advance(1);
            BOOST_REQUIRE(engine->record().flow.back() == 20U);
            left -= 20;
        }
        engine->advance(static_cast<std::int64_t>(all / 20));
        BOOST_TEST(engine->record().flow.back() < 20U);
    }
}

BOOST_AUTO_TEST_CASE(each_move_lifts_a_hole_one_or_two_half_levels) {
    // The heights of all grains together fall by the moves' heights: between 1 and 2 each.
    const auto engine = hopper::make_engine(small_hopper(), EngineKind::fast);
    const auto height = [&](const std::vector<std::uint8_t>& state) {
        std::int64_t sum = 0;
        for (std::size_t k = 0; k < engine->geometry().levels().size(); ++k) {
            const auto& level = engine->geometry().levels()[k];
            for (std::size_t i = 0; i < level.sites(); ++i) {
                if (state[level.offset + i] != 0) sum += static_cast<std::int64_t>(k);
            }
        }
        return sum;  // grains leave from k = 0 and take nothing away
    };
    const auto before = height(engine->state());
    engine->advance(20);
    const auto fallen = before - height(engine->state());
    const auto moves = engine->record().moves;
    BOOST_TEST(moves > 1000);
    BOOST_TEST(fallen > moves);
    BOOST_TEST(fallen < 2 * moves);
}

BOOST_AUTO_TEST_CASE(nothing_is_vacated_before_the_first_iteration_and_the_reach_never_falls) {
    auto p = small_hopper();
    p.levels = 400;  // or the crater would reach the walls at the top
    const auto t = trajectory(p, EngineKind::fast, 40);
    BOOST_TEST(t.left_reach[0] == -1);
    BOOST_TEST(t.right_reach[0] == -1);
    BOOST_TEST(t.left_reach[1] >= 0);  // the outlet's own outermost sites
    BOOST_TEST(std::is_sorted(t.left_reach.begin(), t.left_reach.end()));
    BOOST_TEST(std::is_sorted(t.right_reach.begin(), t.right_reach.end()));
    BOOST_TEST(t.left_reach.back() > 2);
    BOOST_TEST(t.left_reach.back() < 200);
}

BOOST_AUTO_TEST_CASE(a_narrow_hopper_empties_along_its_walls_and_a_wide_one_does_not) {
    auto p = small_hopper();
    p.angle = 4;
    BOOST_TEST(trajectory(p, EngineKind::fast, 60).left_reach.back() > 100);
    p.angle = 90;
    BOOST_TEST(trajectory(p, EngineKind::fast, 60).left_reach.back() < 30);
}
