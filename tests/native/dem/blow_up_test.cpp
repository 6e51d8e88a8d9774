// A run that has blown up stops with an error; it never goes on with numbers that are none.
#include "native/base/errors.hpp"
#include "native/dem/neighbour_list.hpp"
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

dem::State three_far_grains() {
    dem::State state;
    for (int i = 0; i < 3; ++i)
        add_disc(state, 10 * i, 0, 0, 0);
    return state;
}

}  // namespace

BOOST_AUTO_TEST_CASE(positions_that_are_no_numbers_are_refused_at_the_start) {
    for (const double bad : {not_a_number, infinite, -infinite, 1e300}) {
        for (std::size_t i = 0; i < 3; ++i) {
            auto state = three_far_grains();
            state.y[i] = bad;
            BOOST_CHECK_THROW(dem::Engine(free_discs(law_variants[0], 1e-3), state),
                              TrajectoryError);
        }
    }
}

BOOST_AUTO_TEST_CASE(velocities_that_are_no_numbers_stop_the_run_whichever_grain_has_them) {
    for (const double bad : {not_a_number, infinite, -infinite}) {
        for (std::size_t i = 0; i < 3; ++i) {
            auto state = three_far_grains();
            state.vx[i] = bad;
            dem::Engine engine(free_discs(law_variants[0], 1e-3), state);
            BOOST_TEST_CONTEXT("grain " << i << " at speed " << bad) {
                BOOST_CHECK_THROW(engine.advance(1), TrajectoryError);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_lost_position_makes_the_list_outdated_whichever_grain_it_is) {
    const std::vector<double> x{0, 10, 20}, y(3, 0.0);
    for (const double bad : {not_a_number, infinite, -infinite}) {
        for (std::size_t i = 0; i < 3; ++i) {
            dem::NeighbourList list(2.0, 1.0, {}, {});
            list.update(x, y);
            auto lost = x;
            lost[i] = bad;
            BOOST_TEST_CONTEXT("grain " << i << " at " << bad) {
                BOOST_CHECK_THROW(list.update(lost, y), TrajectoryError);
                BOOST_CHECK_THROW(list.update(y, lost), TrajectoryError);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(grains_on_the_same_spot_stop_the_run) {
    // The normal of such a contact is 0/0.
    for (const auto& law : law_variants) {
        dem::State state;
        add_disc(state, 1, 1, 0.5, 0);
        add_disc(state, 1, 1, -0.5, 0);
        add_disc(state, 9, 1, 0, 0);
        BOOST_TEST_CONTEXT(law.name) {
            BOOST_CHECK_THROW(after(free_discs(law, 1e-3), state, 1), TrajectoryError);
        }
    }
}

BOOST_AUTO_TEST_CASE(an_absurd_time_step_stops_the_run_and_names_the_grain) {
    auto p = free_discs(law_variants[0], 1.0);  // ten contact times
    p.period_x = p.period_y = 15;
    try {
        (void)after(p, hot_gas(6, 2.5), 100000);
        BOOST_ERROR("the run went on");
    } catch (const TrajectoryError& error) {
        const std::string line = error.what();
        BOOST_TEST(line.find("grain ") != std::string::npos, line);
        BOOST_TEST(line.find('\n') == std::string::npos, line);
    }
}
