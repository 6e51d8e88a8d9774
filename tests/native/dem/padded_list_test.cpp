// The padded list holds every pair that it should, from both sides, and nobody twice; the tuning of
// the skin finds a cheap one.
#include "native/base/errors.hpp"
#include "native/dem/padded_list.hpp"
#include "native/dem/skin_tuning.hpp"
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

struct Listed {
    std::vector<std::uint32_t> order;
    dem::PaddedList list;
    std::vector<std::multiset<std::size_t>> neighbours;  ///< by number as given
    bool lanes_beyond_the_end_repeat = true, all_are_due = true, groups_end = true;
};

Listed list_of(const std::vector<double>& x, const std::vector<double>& y,
               const dem::PaddedListShape& shape, int threads) {
    Listed result;
    const std::size_t lanes = shape.group.lanes;
    dem::ThreadTeam team(threads);
    dem::PaddedListMaker maker;
    result.order = maker.make(x, y, shape, team, result.list);
    result.neighbours.resize(x.size());
    const std::size_t groups = result.list.crosses.size();
    for (std::size_t group = 0; group < groups; ++group) {
        const float* due = result.list.due.data() + result.list.first_row[group] + group;
        const std::size_t rows = result.list.first_row[group + 1] - result.list.first_row[group];
        result.all_are_due &=
            std::count(due, due + rows, 0.0F) == static_cast<std::ptrdiff_t>(rows);
        result.groups_end &= std::isinf(due[rows]);
        for (std::size_t row = result.list.first_row[group]; row < result.list.first_row[group + 1];
             ++row) {
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const std::size_t place = group * lanes + shape.group.place_of_lane(lane);
                const std::size_t other =
                    result.list.offsets[row * lanes + lane] / shape.record_size;
                if (place >= x.size()) {
                    const std::size_t last =
                        row * lanes + shape.group.slot_of_place(x.size() - 1) % lanes;
                    result.lanes_beyond_the_end_repeat &=
                        result.list.offsets[last] / shape.record_size == other;
                } else if (other < x.size()) {
                    result.neighbours[result.order[place]].insert(result.order[other]);
                }
            }
        }
    }
    return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_pair_within_reach_is_listed_from_both_sides_and_once) {
    for (const bool periodic : {true, false}) {
        for (const dem::GroupShape group : {dem::GroupShape{2, 1}, dem::GroupShape{4, 2},
                                            dem::GroupShape{8, 4}, dem::GroupShape{16, 4}}) {
            for (const int threads : {1, 2}) {
                const double period = 50;
                std::vector<double> x, y;
                for (std::uint64_t i = 0; i < 701; ++i) {
                    x.push_back(period * uniform(1, RandomStream::jitter, 2 * i));
                    y.push_back(40 * uniform(1, RandomStream::jitter, 2 * i + 1) - 10);
                }
                dem::PaddedListShape shape{
                    .diameter = 2, .skin = 0.7, .period_x = {}, .group = group, .record_size = 16};
                if (periodic) shape.period_x = period;
                const auto found = list_of(x, y, shape, threads);
                BOOST_TEST(found.lanes_beyond_the_end_repeat);
                // None is left out before rows are ordered.
                BOOST_TEST(found.all_are_due);
                BOOST_TEST(found.groups_end);
                auto sorted = found.order;
                std::sort(sorted.begin(), sorted.end());
                for (std::size_t i = 0; i < x.size(); ++i) {
                    BOOST_TEST_REQUIRE(sorted[i] == i);
                    for (std::size_t j = 0; j < x.size(); ++j) {
                        const double dx = nearest_image(x[i] - x[j], shape.period_x);
                        const double r = std::hypot(dx, y[i] - y[j]);
                        const auto times = found.neighbours[i].count(j);
                        BOOST_TEST_REQUIRE(times <= 1);
                        if (i != j && r < 2.7) BOOST_TEST_REQUIRE(times == 1);
                        // A little more than asked for, because cells hold floats.
                        if (i == j || r > 2.701) BOOST_TEST_REQUIRE(times == 0);
                    }
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(lanes_and_places_of_a_group_are_inverse_to_each_other) {
    for (const dem::GroupShape group :
         {dem::GroupShape{2, 1}, dem::GroupShape{4, 1}, dem::GroupShape{4, 2},
          dem::GroupShape{8, 2}, dem::GroupShape{8, 4}, dem::GroupShape{16, 4}}) {
        for (std::size_t lane = 0; lane < group.lanes; ++lane) {
            const std::size_t place = 3 * group.lanes + group.place_of_lane(lane);
            BOOST_TEST(group.slot_of_place(place) == 3 * group.lanes + lane);
        }
    }
}

BOOST_AUTO_TEST_CASE(groups_that_reach_across_the_period_are_marked) {
    const std::vector<double> x{0.5, 20, 31.5, 12}, y{0, 0, 0, 0};
    const auto found = list_of(
        x, y, {.diameter = 2, .skin = 0.5, .period_x = 32.0, .group = {2, 1}, .record_size = 32},
        1);
    for (std::size_t place = 0; place < 4; ++place) {
        const std::size_t i = found.order[place];
        if (i == 0 || i == 2) BOOST_TEST(found.list.crosses[place / 2] == 1);
    }
    BOOST_TEST(found.neighbours[0].count(2) == 1);
    BOOST_TEST(found.neighbours[1].empty());
}

BOOST_AUTO_TEST_CASE(grains_all_in_one_place_are_an_error) {
    const std::vector<double> x(400, 5.0), y(400, 1.0);
    BOOST_CHECK_THROW(
        list_of(x, y,
                {.diameter = 2, .skin = 0.5, .period_x = 32.0, .group = {4, 1}, .record_size = 32},
                1),
        TrajectoryError);
}

BOOST_AUTO_TEST_CASE(the_skin_settles_where_the_cost_is_least) {
    // Rows grow as the listed area, a list lasts in proportion to the skin: the best skin has
    // d/ds [c (2 + s)^2 + (160 + 2 15)/(150 s)] = 0, near 0.7 for c = 0.8 and two orders of rows.
    const auto cost = [](double s) { return 0.8 * (2 + s) * (2 + s) + 190 / (150 * s); };
    double best = 0.1;
    for (double s = 0.1; s < 2; s += 0.001) {
        if (cost(s) < cost(best)) best = s;
    }
    for (const double start : {0.2, 1.9}) {
        dem::SkinTuning tuning(start, 0.1, 2.0);
        for (int lists = 0; lists < 24 * 60; ++lists) {
            const double s = tuning.skin();
            const auto steps = std::lround(150 * s);
            tuning.list_has_lasted(steps, 2, static_cast<double>(steps) * 0.8 * (2 + s) * (2 + s));
        }
        BOOST_TEST_CONTEXT("best " << best << ", found " << tuning.skin()) {
            BOOST_TEST(cost(tuning.skin()) < 1.03 * cost(best));
        }
    }
    // A skin that was asked for stays.
    dem::SkinTuning fixed(0.5, 0.5, 0.5);
    for (int lists = 0; lists < 100; ++lists)
        fixed.list_has_lasted(10, 1, 5);
    BOOST_TEST(fixed.skin() == 0.5);
}
