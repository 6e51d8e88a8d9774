// The sites of a hopper: those of the definition, one by one, and the steps between them.
#include "native/hopper/geometry.hpp"
#include "tests/native/hopper/hoppers.hpp"

#include <algorithm>
#include <set>

using namespace crossgrain;
using namespace crossgrain::tests;
using hopper::Geometry;

namespace {

/// The definition, without any arithmetic of columns.
bool is_site(int k, int c, int outlet, double angle) {
    const double x = c * std::sqrt(3.0) / 2, y = k / 2.0;
    const double x0 = (outlet - 1) * std::sqrt(3.0) / 2;
    return (c + k + outlet - 1) % 2 == 0 &&
           std::abs(x) <= x0 + y * std::tan(angle / 2 * std::numbers::pi / 180) + 1e-9;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_paper_s_hopper_has_76706_sites) {
    const Geometry g(20, 800, slope_3);
    BOOST_TEST(g.sites() == 76706);
    BOOST_TEST(g.levels()[0].sites() == 20);
    BOOST_TEST(g.levels().size() == 800);
    BOOST_TEST(std::abs(hopper::approximate_sites(20, 800, slope_3) / 76706 - 1) < 0.01);
}

BOOST_AUTO_TEST_CASE(levels_hold_exactly_the_sites_between_the_walls) {
    for (const double angle : {1.0, slope_3, 60.0, 90.0, 120.0, 150.0}) {
        for (const int outlet : {2, 5, 8}) {
            const Geometry g(outlet, 30, angle);
            std::size_t count = 0;
            for (int k = 0; k < 30; ++k) {
                const auto& level = g.levels()[static_cast<std::size_t>(k)];
                BOOST_TEST(level.offset == count);
                for (int c = -500; c <= 500; ++c) {
                    const bool listed =
                        c >= level.first && c <= level.last && (c - level.first) % 2 == 0;
                    if (listed != is_site(k, c, outlet, angle)) {
                        BOOST_ERROR("(" << k << ", " << c << "), theta = " << angle);
                    }
                    count += listed;
                }
            }
            BOOST_TEST(g.sites() == count);
        }
    }
}

BOOST_AUTO_TEST_CASE(places_are_distinct_and_neighbours_a_constant_step_away) {
    const std::vector<std::array<int, 2>> steps{{0, 0}, {0, 0},  {1, -1}, {2, 0},
                                                {1, 1}, {-1, 1}, {-2, 0}, {-1, -1}};
    const Geometry g(7, 20, 70);
    std::set<std::size_t> places;
    for (int k = 0; k < 20; ++k) {
        const auto& level = g.levels()[static_cast<std::size_t>(k)];
        for (int c = level.first; c <= level.last; c += 2) {
            BOOST_TEST(places.insert(g.place(k, c)).second);
            for (int j = 2; j <= 7; ++j) {
                const auto [dk, dc] = steps[static_cast<std::size_t>(j)];
                const auto there = g.place(k + dk, c + dc);
                BOOST_TEST(there == g.place(k, c) + static_cast<std::size_t>(g.step(j)));
                BOOST_TEST(there < g.stored());
            }
        }
    }
    // What the fast engine relies on.
    BOOST_TEST(g.step(4) == g.step(2) + 1);
    BOOST_TEST(g.step(5) == -g.step(2));
    BOOST_TEST(g.step(6) == -g.step(3));
    BOOST_TEST(g.step(7) == -g.step(4));
}

BOOST_AUTO_TEST_CASE(ghosts_are_empty_below_the_outlet_and_above_the_filling_and_walls_elsewhere) {
    const int outlet = 4, levels = 6;
    const Geometry g(outlet, levels, slope_3);
    const auto field = g.empty_field();
    std::size_t empty = 0;
    for (int k = -2; k < levels + 2; ++k) {
        for (int c = -12; c <= 12; ++c) {
            if ((c + k + outlet - 1) % 2 != 0) continue;
            const bool inside = is_site(k < 0 ? -k % 2 : k, c, outlet, k < 0 ? 1e-9 : slope_3);
            if (std::abs(c) > g.levels().back().last + 2) continue;
            BOOST_TEST(field[g.place(k, c)] == (inside ? 0 : hopper::outside));
            empty += inside;
        }
    }
    BOOST_TEST(static_cast<std::size_t>(std::count(field.begin(), field.end(), 0)) == empty);
}
