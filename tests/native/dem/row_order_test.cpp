// Protects the order of the rows of the neighbour list: no pair may touch before its row is due,
// whatever contacts within the limit do to it, and rows may not be due at once for safety's sake.
#include "native/base/instruction_sets.hpp"
#include "native/base/random.hpp"
#include "native/dem/padded_list.hpp"
#include "native/dem/simd_coordinates.hpp"
#include "native/dem/simd_step.hpp"
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;
using namespace crossgrain::dem;

namespace {

constexpr std::size_t grains = 301;
constexpr double diameter = 2, period = 40, height = 30, skin = 1.5, dt = 1e-2;
constexpr double acceleration = 3;
constexpr float horizon = 40;

struct Gas {
    std::vector<double> x, y, vx, vy;
};

Gas hot_discs() {
    Gas gas;
    for (std::uint64_t i = 0; i < grains; ++i) {
        const auto v = normal_pair(3, RandomStream::initial_velocity, i);
        gas.x.push_back(period * uniform(3, RandomStream::jitter, 2 * i));
        gas.y.push_back(height * uniform(3, RandomStream::jitter, 2 * i + 1));
        gas.vx.push_back(3 * v[0]);
        gas.vy.push_back(3 * v[1]);
    }
    return gas;
}

/// The first step in which the pair can touch, step 1 being the present one: both are pushed
/// towards each other all the time, and have been in the half step before.
int earliest_touch(const Gas& gas, std::size_t i, std::size_t j) {
    double dx = nearest_image(gas.x[i] - gas.x[j], period), dy = gas.y[i] - gas.y[j];
    double dvx = gas.vx[i] - gas.vx[j], dvy = gas.vy[i] - gas.vy[j];
    for (int step = 1; step <= static_cast<int>(horizon) + 1; ++step) {
        const double r = std::hypot(dx, dy);
        if (r <= diameter) return step;
        const double push = 2 * acceleration * dt * (step == 1 ? 1.5 : 1.0);
        dvx -= push * dx / r;
        dvy -= push * dy / r;
        dx += dt * dvx;
        dy += dt * dvy;
    }
    return std::numeric_limits<int>::max();
}

template <class Format>
struct Listed {
    StepFunctions<Format> functions;
    std::vector<std::uint32_t> order;
    PaddedList list;
    Records<Format> records;
    StepConstants<Format> constants;
};

template <class Format>
Listed<Format> list_of(const Gas& gas, StepFunctions<Format> functions, dem::Parameters p) {
    using Real = typename Format::Real;
    Listed<Format> made{.functions = std::move(functions)};
    ThreadTeam team(1);
    PaddedListMaker maker;
    const GroupShape group = made.functions.group;
    made.order = maker.make(gas.x, gas.y,
                            {.diameter = diameter,
                             .skin = skin,
                             .period_x = period,
                             .group = group,
                             .record_size = sizeof(typename Format::Record)},
                            team, made.list);
    p.diameter = diameter;
    p.period_x = period;
    Coordinates<Format> coordinates(p);
    coordinates.fit(0, height);
    const std::size_t padded = (grains + group.lanes - 1) / group.lanes * group.lanes;
    for (std::size_t place = 0; place < padded; ++place) {
        const std::size_t i = made.order[std::min(place, grains - 1)];
        made.records.push_back({coordinates.x(gas.x[i]), coordinates.y(gas.y[i]),
                                static_cast<Real>(gas.vx[i]), static_cast<Real>(gas.vy[i])});
    }
    made.records.push_back({0, coordinates.dummy_y(), 0, 0});
    made.constants = {.diameter = static_cast<Real>(diameter),
                      .dt = static_cast<Real>(dt),
                      .unit_x = static_cast<Real>(coordinates.unit_x()),
                      .unit_y = static_cast<Real>(coordinates.unit_y()),
                      .period = static_cast<Real>(period),
                      .inverse_period = static_cast<Real>(1 / period)};
    return made;
}

struct Judgement {
    int late = 0, early = 0, rows = 0, rows_beyond_horizon = 0;
    bool neighbours_are_kept = true, rows_are_in_order = true;
};

/// With rows ordered as if contacts accelerated by no more than this.
template <class Format>
Judgement judge(const Gas& gas, Listed<Format> made, double assumed_acceleration) {
    const PaddedList before = made.list;
    const std::size_t lanes = made.functions.group.lanes;
    const std::size_t groups = before.crosses.size();
    made.functions.order_rows({.constants = &made.constants,
                               .now = made.records.data(),
                               .list = &made.list,
                               .first_group = 0,
                               .last_group = groups,
                               .acceleration = assumed_acceleration * dt * dt,
                               .horizon = horizon});
    Judgement judgement;
    for (std::size_t group = 0; group < groups; ++group) {
        const std::size_t first = before.first_row[group], last = before.first_row[group + 1];
        const float* due = made.list.due.data() + first + group;
        judgement.rows_are_in_order &= std::is_sorted(due, due + (last - first) + 1);
        std::vector<int> touches(last - first, std::numeric_limits<int>::max());
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::size_t place = group * lanes + made.functions.group.place_of_lane(lane);
            const std::size_t i = made.order[std::min(place, grains - 1)];
            std::vector<std::uint32_t> was, is;
            for (std::size_t row = first; row < last; ++row) {
                was.push_back(before.offsets[row * lanes + lane]);
                is.push_back(made.list.offsets[row * lanes + lane]);
                const std::size_t other = is.back() / sizeof(typename Format::Record);
                if (other >= grains) continue;
                int& touch = touches[row - first];
                touch = std::min(touch, earliest_touch(gas, i, made.order[other]));
            }
            std::sort(was.begin(), was.end());
            std::sort(is.begin(), is.end());
            judgement.neighbours_are_kept &= was == is;
        }
        for (std::size_t row = 0; row < last - first; ++row) {
            const int touch =
                *std::min_element(touches.begin() + static_cast<long>(row), touches.end());
            ++judgement.rows;
            if (due[row] > horizon) ++judgement.rows_beyond_horizon;
            if (due[row] > static_cast<float>(touch)) ++judgement.late;
            const int seen = std::min(touch, static_cast<int>(horizon) + 1);
            if (due[row] < 0.8F * static_cast<float>(seen) - 2) ++judgement.early;
        }
    }
    return judgement;
}

template <class Format>
void check(StepFunctions<Format> (*functions)(const dem::Parameters&)) {
    const Gas gas = hot_discs();
    const auto p = free_discs(law_variants[0], dt);
    const auto made = list_of<Format>(gas, functions(p), p);
    const Judgement judgement = judge(gas, made, acceleration);
    BOOST_TEST_CONTEXT(made.functions.instruction_set << ", " << judgement.rows << " rows, "
                                                      << judgement.rows_beyond_horizon
                                                      << " due after the horizon") {
        BOOST_TEST(judgement.neighbours_are_kept);
        BOOST_TEST(judgement.rows_are_in_order);
        BOOST_TEST(judgement.late == 0);
        // What passes by would have touched by the bound.
        BOOST_TEST(judgement.early < judgement.rows / 15);
        BOOST_TEST(judgement.rows_beyond_horizon > judgement.rows / 10);
        // What this test would say of a limit that does not hold.
        BOOST_TEST(judge(gas, made, acceleration / 3).late > 0);
        BOOST_TEST(judge(gas, made, acceleration * 3).early > judgement.rows / 15);
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_pair_touches_before_its_row_is_due) {
    check<dem::MixedFormat>(dem::mixed_step_functions);
    check<dem::DoubleFormat>(dem::double_step_functions);
    const WithoutAvx512 older;
    check<dem::MixedFormat>(dem::mixed_step_functions);
    check<dem::DoubleFormat>(dem::double_step_functions);
}
