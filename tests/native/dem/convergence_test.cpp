// Order of convergence of both schemes on smooth trajectories: within one contact nothing jumps.
// The half step sees the dashpot's velocity dt/2 late and is of first order; the predicted
// velocity is of second. Without a dashpot in play both are of second order.
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

// The local order tends to the order linearly in dt; 0.04/40 and finer is within 0.05 of it.
constexpr double order_band = 0.1;
constexpr double duration = 0.04;
constexpr std::int64_t coarsest = 40;

/// Smallest and largest order measured by halving the step three times.
struct Orders {
    double least = 100, most = -100;
};

Orders measure(const std::function<double(std::int64_t steps)>& error) {
    Orders orders;
    double coarse = error(coarsest);
    for (std::int64_t steps = 2 * coarsest; steps <= 8 * coarsest; steps *= 2) {
        const double fine = error(steps);
        const double order = std::log2(coarse / fine);
        orders = {std::min(orders.least, order), std::max(orders.most, order)};
        coarse = fine;
    }
    return orders;
}

void check(const Orders& orders, double expected) {
    BOOST_TEST_CONTEXT("orders from " << orders.least << " to " << orders.most) {
        BOOST_TEST(orders.least > expected - order_band);
        BOOST_TEST(orders.most < expected + order_band);
    }
}

dem::State run(dem::Parameters p, const dem::State& start, std::int64_t steps) {
    p.dt = duration / static_cast<double>(steps);
    return after(p, start, steps);
}

/// Error against a run of second order with a step 64 times the finest measured.
Orders against_fine_run(const dem::Parameters& p, const dem::State& start) {
    auto fine = p;
    fine.scheme = dem::Scheme::verlet_predicted;
    const auto truth = run(fine, start, 512 * coarsest);
    return measure(
        [&](std::int64_t steps) { return largest_difference(run(p, start, steps), truth); });
}

/// Two grains that overlap from the start and approach obliquely; still in contact at the end.
dem::State oblique_contact() {
    dem::State state;
    add_disc(state, 0, 0, 0.5, 0.4);
    add_disc(state, 1.8, 0.85, -0.5, -0.2);
    return state;
}

double overlap(const dem::State& s) {
    return 2 - std::hypot(s.x[0] - s.x[1], s.y[0] - s.y[1]);
}

double expected_order(const dem::Parameters& p) {
    return p.scheme == dem::Scheme::verlet_half_step && p.damping > 0 ? 1 : 2;
}

}  // namespace

BOOST_AUTO_TEST_CASE(both_schemes_converge_to_the_damped_oscillator_at_their_order) {
    // Overlap of a head-on contact: x'' + 2 g x' + w0^2 x = 0 with g = eta/m, w0^2 = 2 k/m.
    dem::State pair;
    add_disc(pair, -0.995, 0, 0.5, 0);
    add_disc(pair, 0.995, 0, -0.5, 0);
    for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
        auto p = free_discs(law_variants[0], 0);
        p.scheme = scheme;
        const double g = p.damping, w = std::sqrt(2 * p.stiffness - g * g);
        const double exact =
            std::exp(-g * duration) *
            (0.01 * std::cos(w * duration) + (1 + 0.01 * g) / w * std::sin(w * duration));
        check(measure([&](std::int64_t steps) {
                  return std::abs(overlap(run(p, pair, steps)) - exact);
              }),
              expected_order(p));
        const double last = overlap(run(p, pair, 64 * coarsest));
        // g dt w t = 4e-5 is the error of the half step, the smaller one's square is far below.
        BOOST_TEST(last == exact, tt::tolerance(2e-3));
    }
}

BOOST_AUTO_TEST_CASE(every_law_converges_at_its_order_in_an_oblique_contact) {
    for (const auto& law : law_variants) {
        for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
            auto p = free_discs(law, 0);
            p.scheme = scheme;
            BOOST_TEST_CONTEXT(law.name) {
                BOOST_TEST(overlap(oblique_contact()) > 0);
                BOOST_TEST(overlap(run(p, oblique_contact(), coarsest)) > 0);
                check(against_fine_run(p, oblique_contact()), expected_order(p));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(every_law_converges_at_second_order_without_dashpot) {
    for (const auto& law : law_variants) {
        for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
            auto p = free_discs(law, 0);
            p.scheme = scheme;
            p.damping = 0;
            BOOST_TEST_CONTEXT(law.name) {
                check(against_fine_run(p, oblique_contact()), 2);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_grain_on_a_moving_plate_converges_at_second_order) {
    for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
        auto p = free_discs(law_variants[0], 0);
        p.scheme = scheme;
        p.gravity = 1;
        p.plate_stiffness = p.stiffness;
        p.bottom = dem::MovingPlate{.height = -0.5, .amplitude = 0.5, .omega = 5};
        dem::State grain;
        add_disc(grain, 0, -0.02, 0, -1);
        check(against_fine_run(p, grain), 2);
    }
}

BOOST_AUTO_TEST_CASE(a_grain_and_a_free_lid_converge_at_second_order) {
    for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
        auto p = free_discs(law_variants[0], 0);
        p.scheme = scheme;
        p.gravity = 1;
        p.plate_stiffness = p.stiffness;
        p.lid = dem::InertialLid{.mass = 3};
        dem::State grain;
        add_disc(grain, 0, 0.02, 0, 1);
        check(against_fine_run(p, grain), 2);
    }
}
