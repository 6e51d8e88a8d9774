// Over a long run of a hot gas the list never misses a contact, and is not rebuilt for nothing.
#include "native/dem/neighbour_list.hpp"
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

struct Contacts {
    std::int64_t missed = 0, seen = 0, builds = 0;
};

using Overlaps = std::vector<std::vector<double>>;

/// Overlaps of all pairs, by a double loop and by the list.
Overlaps by_double_loop(const dem::Parameters& p, const dem::State& s) {
    Overlaps overlap(s.x.size(), std::vector<double>(s.x.size(), 0.0));
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        for (std::size_t j = i + 1; j < s.x.size(); ++j) {
            const double r = std::hypot(nearest_image(s.x[i] - s.x[j], p.period_x),
                                        nearest_image(s.y[i] - s.y[j], p.period_y));
            if (r < p.diameter) overlap[i][j] = p.diameter - r;
        }
    }
    return overlap;
}

Overlaps by_list(const dem::NeighbourList& list, const dem::Parameters& p, const dem::State& s) {
    Overlaps overlap(s.x.size(), std::vector<double>(s.x.size(), 0.0));
    for (const auto& pair : list.pairs()) {
        const double r = std::hypot(s.x[pair.i] - s.x[pair.j] + pair.shift_x,
                                    s.y[pair.i] - s.y[pair.j] + pair.shift_y);
        if (r < p.diameter) overlap[pair.i][pair.j] += p.diameter - r;
    }
    return overlap;
}

/// Runs the engine and, beside it, a list with the engine's own skin of half a diameter.
Contacts follow(const dem::Parameters& p, const dem::State& start, std::int64_t steps) {
    dem::Engine engine(p, start);
    dem::NeighbourList list(p.diameter, p.diameter / 2, p.period_x, p.period_y);
    Contacts contacts;
    for (std::int64_t step = 0; step <= steps; ++step) {
        const auto& s = engine.state();
        list.update(s.x, s.y);
        const auto expected = by_double_loop(p, s), found = by_list(list, p, s);
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            for (std::size_t j = i + 1; j < s.x.size(); ++j) {
                contacts.seen += expected[i][j] > 0;
                // 1e-12: rounding of the two distances; a missed contact is larger or harmless.
                contacts.missed += std::abs(expected[i][j] - found[i][j]) > 1e-12;
            }
        }
        engine.advance(1);
    }
    contacts.builds = list.builds();
    return contacts;
}

void check(const dem::Parameters& p, const dem::State& start, std::int64_t steps) {
    const auto contacts = follow(p, start, steps);
    BOOST_TEST_MESSAGE(contacts.seen << " contacts, " << contacts.builds << " lists in " << steps
                                     << " steps");
    BOOST_TEST(contacts.missed == 0);
    BOOST_TEST(contacts.seen > 1000);
    BOOST_TEST(contacts.builds > 10);
    BOOST_TEST(contacts.builds < steps / 4);
}

/// Elastic, so that it stays hot.
dem::Parameters elastic() {
    auto p = free_discs(law_variants[0], 1e-3);
    p.damping = 0;
    return p;
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_contact_is_missed_in_a_doubly_periodic_gas) {
    auto p = elastic();
    p.period_x = p.period_y = 15;
    check(p, hot_gas(6, 2.5), 8000);
}

BOOST_AUTO_TEST_CASE(no_contact_is_missed_between_plates) {
    auto p = elastic();
    p.period_x = 15;
    p.plate_stiffness = p.stiffness;
    p.bottom = dem::MovingPlate{.height = 0};
    p.lid = dem::MovingPlate{.height = 15};
    p.gravity = 1;
    check(p, hot_gas(6, 2.5), 8000);
}

BOOST_AUTO_TEST_CASE(no_contact_is_missed_in_a_tiny_box) {
    auto p = elastic();
    p.period_x = p.period_y = 6;  // three diameters
    dem::State state;
    for (int i = 0; i < 4; ++i)
        add_disc(state, 3 * (i % 2) + 0.1 * i, 3 * (i / 2), 1.7 * (i % 3 - 1), 2.0 - i);
    check(p, state, 20000);
}

BOOST_AUTO_TEST_CASE(no_contact_is_missed_in_front_of_a_bullet) {
    // A grain that crosses a skin in a few steps while all others crawl, towards an open end.
    auto p = elastic();
    p.dt = 2e-4;
    auto state = hot_gas(6, 2.5);
    for (std::size_t i = 0; i < 36; ++i) {
        state.vx[i] *= 0.01;
        state.vy[i] *= 0.01;
    }
    add_disc(state, -20, 7, 40, 1);
    check(p, state, 8000);
}

BOOST_AUTO_TEST_CASE(a_list_is_kept_until_a_grain_has_moved_by_half_the_skin) {
    dem::NeighbourList list(2.0, 1.0, {}, {});
    const std::vector<double> y{0, 0};
    list.update(std::vector{0.0, 3.5}, y);
    BOOST_TEST(list.builds() == 1);
    BOOST_TEST(list.pairs().empty());
    list.update(std::vector{0.5, 3.5}, y);  // exactly half the skin: the pair is still out of reach
    BOOST_TEST(list.builds() == 1);
    list.update(std::vector{0.5625, 3.5}, y);
    BOOST_TEST(list.builds() == 2);
    BOOST_TEST(list.pairs().size() == 1u);
}
