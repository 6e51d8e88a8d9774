// A fresh list holds exactly the pairs that a double loop over all pairs finds, each once, with the
// shift to the nearest image.
#include "native/dem/neighbour_list.hpp"

#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

using namespace crossgrain;
using dem::NeighbourList;

namespace {

constexpr double reach = 2.0, skin = 1.0;

struct Discs {
    std::vector<double> x, y;
    std::optional<double> period_x, period_y;
};

/// n discs anywhere in a box whose lower left corner is (left, low).
Discs scattered(std::uint64_t n, double width, double height, std::uint64_t seed, double left = 0,
                double low = 0) {
    Discs discs;
    for (std::uint64_t i = 0; i < n; ++i) {
        discs.x.push_back(left + width * uniform(seed, RandomStream::initial_position, i));
        discs.y.push_back(low + height * uniform(seed, RandomStream::jitter, i));
    }
    return discs;
}

double nearest_image(double separation, const std::optional<double>& period) {
    return period ? std::remainder(separation, *period) : separation;
}

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Pairs brute_force(const Discs& discs) {
    Pairs pairs;
    for (std::size_t i = 0; i < discs.x.size(); ++i) {
        for (std::size_t j = i + 1; j < discs.x.size(); ++j) {
            const double dx = nearest_image(discs.x[i] - discs.x[j], discs.period_x);
            const double dy = nearest_image(discs.y[i] - discs.y[j], discs.period_y);
            if (std::hypot(dx, dy) < reach + skin) pairs.emplace_back(i, j);
        }
    }
    return pairs;
}

/// Holds the list against the double loop; returns the number of pairs.
std::size_t check(const Discs& discs) {
    NeighbourList list(reach, skin, discs.period_x, discs.period_y);
    list.update(discs.x, discs.y);
    Pairs found;
    double worst_image = 0;
    for (const auto& pair : list.pairs()) {
        found.emplace_back(std::min(pair.i, pair.j), std::max(pair.i, pair.j));
        const double dx = discs.x[pair.i] - discs.x[pair.j], dy = discs.y[pair.i] - discs.y[pair.j];
        worst_image =
            std::max({worst_image, std::abs(dx + pair.shift_x - nearest_image(dx, discs.period_x)),
                      std::abs(dy + pair.shift_y - nearest_image(dy, discs.period_y))});
        BOOST_TEST_REQUIRE((discs.period_x.has_value() || pair.shift_x == 0));
        BOOST_TEST_REQUIRE((discs.period_y.has_value() || pair.shift_y == 0));
    }
    std::sort(found.begin(), found.end());
    const bool same = found == brute_force(discs);
    BOOST_TEST(same, found.size() << " pairs instead of " << brute_force(discs).size());
    BOOST_TEST(worst_image < 1e-9);  // positions up to 1e5: a few roundings of 1e-11
    return found.size();
}

}  // namespace

BOOST_AUTO_TEST_CASE(open_systems_of_any_density) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        for (const double side : {3.0, 8.0, 20.0, 60.0, 1000.0}) {
            (void)check(scattered(100, side, side, seed, -side / 3, -5));
        }
    }
    BOOST_TEST(check(scattered(100, 20, 20, 1)) > 100u);  // not an empty question
}

BOOST_AUTO_TEST_CASE(systems_that_are_periodic_along_x) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        for (const double period : {6.0, 7.3, 9.0, 12.0, 30.0}) {
            auto discs = scattered(60, period, 20, seed);
            discs.period_x = period;
            (void)check(discs);
        }
    }
}

BOOST_AUTO_TEST_CASE(systems_that_are_periodic_along_x_and_y) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        for (const double period : {6.0, 8.9, 9.0, 11.99, 30.0}) {
            auto discs = scattered(60, period, period + 1, seed);
            discs.period_x = period;
            discs.period_y = period + 1;
            (void)check(discs);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_box_of_barely_three_diameters) {
    // The smallest period allowed, 2 (reach + skin): two cells, each the other's neighbour twice.
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        auto discs = scattered(9, 6, 6, seed);
        discs.period_x = discs.period_y = 6.0;
        BOOST_TEST(check(discs) > 0u);
    }
}

BOOST_AUTO_TEST_CASE(unwrapped_positions_many_periods_away) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        auto discs = scattered(60, 15, 15, seed);
        discs.period_x = discs.period_y = 15;
        const auto at_home = brute_force(discs);
        for (std::uint64_t i = 0; i < discs.x.size(); ++i) {
            discs.x[i] += 15 * std::floor(1000 * normal_pair(seed, RandomStream::jitter, i)[0]);
            discs.y[i] -= 15 * std::floor(1000 * normal_pair(seed, RandomStream::jitter, i)[1]);
        }
        BOOST_TEST(check(discs) == at_home.size());
    }
}

BOOST_AUTO_TEST_CASE(grains_on_cell_and_box_boundaries) {
    Discs discs;
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 5; ++column) {
            discs.x.push_back(3.0 * column);  // the cells' own width
            discs.y.push_back(2.5 * row);
        }
    }
    BOOST_TEST(check(discs) > 0u);
    discs.period_x = 15;
    BOOST_TEST(check(discs) > 0u);
    discs.period_y = 12.5;
    BOOST_TEST(check(discs) > 0u);
    for (double& x : discs.x)
        x -= 15;
    (void)check(discs);
}

BOOST_AUTO_TEST_CASE(far_flung_grains) {
    for (const double far : {1e3, 1e5, 1e9, 1e12}) {
        auto discs = scattered(80, 15, 15, 3);
        const auto near = brute_force(discs).size();
        discs.x.insert(discs.x.end(), {far, -far, 0, far});
        discs.y.insert(discs.y.end(), {far, 0, -far, far});
        BOOST_TEST(check(discs) == near + 1);  // the two at (far, far)
    }
}

BOOST_AUTO_TEST_CASE(all_grains_in_one_line) {
    for (const double length : {0.0, 5.0, 50.0, 5000.0}) {
        for (const double tilt : {0.0, 1.0}) {
            auto discs = scattered(60, length, 0, 5);
            for (std::size_t i = 0; i < discs.x.size(); ++i)
                discs.y[i] = tilt * discs.x[i];
            (void)check(discs);
            std::swap(discs.x, discs.y);
            (void)check(discs);
        }
    }
}

BOOST_AUTO_TEST_CASE(no_grain_and_one_grain_have_no_pairs) {
    BOOST_TEST(check({}) == 0u);
    BOOST_TEST(check(scattered(1, 1, 1, 1)) == 0u);
    auto alone = scattered(1, 1, 1, 1);
    alone.period_x = alone.period_y = 6;
    BOOST_TEST(check(alone) == 0u);  // nor is a grain its own image's neighbour
}
