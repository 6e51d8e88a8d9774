// The fast engine is the plain one, bit for bit: over readings, coefficients, angles, sizes and
// both kinds of random numbers.
#include "native/hopper/fast_engine.hpp"
#include "native/hopper/plain_engine.hpp"
#include "tests/native/hopper/hoppers.hpp"

#include <string>

using namespace crossgrain;
using namespace crossgrain::tests;
using hopper::EngineKind;

namespace {

void check_same(const hopper::Parameters& p, std::int64_t iterations) {
    BOOST_TEST_CONTEXT("N = " << p.outlet << ", L = " << p.levels << ", theta = " << p.angle
                              << ", C_D = " << p.rules.c_d << ", C_O = " << p.rules.c_o
                              << ", C_I = " << p.rules.c_i << ", C_W = " << p.rules.c_w) {
        const auto plain = trajectory(p, EngineKind::plain, iterations);
        BOOST_TEST((plain == trajectory(p, EngineKind::fast, iterations)));
        BOOST_TEST((plain.moves.back() > 0 || p.levels == 1));
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_reading_and_kind_of_random_numbers) {
    for (const auto sweep : {hopper::Sweep::bottom_to_top, hopper::Sweep::top_to_bottom}) {
        for (const auto rows : {hopper::Rows::half_levels, hopper::Rows::zigzag}) {
            for (const auto inertia :
                 {hopper::Inertia::source_orientation, hopper::Inertia::literal}) {
                for (const bool rotation : {true, false}) {
                    for (const auto random :
                         {hopper::RandomSource::per_site, hopper::RandomSource::shared_stream}) {
                        auto p = small_hopper();
                        p.levels = 40;
                        p.sweep = sweep;
                        p.rows = rows;
                        p.random = random;
                        p.rules.inertia = inertia;
                        p.rules.rotation = rotation;
                        check_same(p, 30);
                    }
                }
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(coefficients_and_tie_tolerances_on_both_sides_of_their_thresholds) {
    auto p = small_hopper();
    p.levels = 40;
    for (const double c_d : {0.0, 1e-4, 0.01, 0.09, 0.1, 0.11, 1.0}) {
        for (const double c_o : {0.0, 5e-4, 9e-4, 1e-3, 2e-3, 0.5}) {
            for (const double tie_tolerance : {0.0, 1e-3}) {
                p.rules = {.c_d = c_d,
                           .c_o = c_o,
                           .c_i = 0.1,
                           .c_w = c_d < 0.1 ? 0.1 : 10,
                           .tie_tolerance = tie_tolerance};
                ++p.seed;
                check_same(p, 20);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(angles_and_sizes) {
    auto p = small_hopper();
    for (const double angle : {0.1, 10.0, 60.0, 90.0, 119.0, 121.0, 160.0}) {
        for (const int outlet : {2, 3, 17}) {
            for (const int levels : {1, 2, 3, 25}) {
                p.angle = angle;
                p.outlet = outlet;
                p.levels = levels;
                ++p.run;
                check_same(p, 25);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(until_the_hopper_is_empty) {
    // The crater, where most holes wait for grains to arrive, is the hard part of the lists.
    auto p = small_hopper();
    for (const double c_d : {0.01, 1.0}) {
        p.rules.c_d = c_d;
        check_same(p, 400);
    }
    p.outlet = 80;  // more holes on a level than one vector
    p.levels = 60;
    check_same(p, 60);
}

BOOST_AUTO_TEST_CASE(blocks_of_iterations_are_the_same_as_single_ones) {
    const auto p = small_hopper();
    const auto at_once = hopper::make_engine(p, EngineKind::fast);
    at_once->advance(0);
    at_once->advance(30);
    BOOST_TEST((at_once->state() == trajectory(p, EngineKind::fast, 30).states.back()));
}

BOOST_AUTO_TEST_CASE(a_planted_difference_is_seen) {
    // The comparison itself: a table of other rules, another seed, one grain turned.
    const auto p = small_hopper();
    const auto right = trajectory(p, EngineKind::plain, 20);

    auto other_rules = p.rules;
    other_rules.c_d = 0.11;
    hopper::FastEngine wrong_table(
        p, std::make_shared<hopper::CandidateTable>(hopper::integer_energies(other_rules)));
    BOOST_TEST((right != trajectory(wrong_table, 20)));

    auto other = p;
    ++other.seed;
    BOOST_TEST((right != trajectory(other, EngineKind::fast, 20)));
    other = p;
    ++other.run;
    BOOST_TEST((right != trajectory(other, EngineKind::fast, 20)));
    other = p;
    other.flipped = 1;
    BOOST_TEST((right != trajectory(other, EngineKind::fast, 0)));
}
