// Bounce on an elastic plate against conservation laws and a numerical integration.
#include "reference/analytic/plate_bounce.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain::analytic;

BOOST_AUTO_TEST_CASE(plate_at_rest_reflects_the_grain) {
    const auto bounce = plate_bounce({.stiffness = 496, .grain_mass = 1, .grain_velocity = -3});
    BOOST_TEST(bounce.contact_time == std::numbers::pi / std::sqrt(496.0), tt::tolerance(1e-15));
    BOOST_TEST(bounce.grain_velocity == 3);
    BOOST_TEST(bounce.plate_velocity == 0);
}

BOOST_AUTO_TEST_CASE(free_lid_conserves_momentum_and_energy_and_reverses_the_approach) {
    const PlateImpact in{.stiffness = 7,
                         .grain_mass = 1.5,
                         .plate_mass = 0.1,
                         .grain_velocity = 2,
                         .plate_velocity = -0.7};
    const auto out = plate_bounce(in);
    const auto momentum = [&](double v, double V) { return in.grain_mass * v + in.plate_mass * V; };
    const auto energy = [&](double v, double V) {
        return in.grain_mass * v * v + in.plate_mass * V * V;
    };
    // A few roundings.
    BOOST_TEST(momentum(out.grain_velocity, out.plate_velocity) == momentum(2, -0.7),
               tt::tolerance(1e-14));
    BOOST_TEST(energy(out.grain_velocity, out.plate_velocity) == energy(2, -0.7),
               tt::tolerance(1e-14));
    BOOST_TEST(out.grain_velocity - out.plate_velocity == -2.7, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(free_lid_agrees_with_numerical_integration) {
    const double k = 7, m = 1.5, M = 0.1;
    // Velocity Verlet: global error (omega dt)^2/24, 1e-9 for the step below.
    const double dt = std::sqrt(m * M / (m + M) / k) * 1e-4;
    double y = 0, v = 2, h = 0, V = -0.7, t = 0;
    double force = 0, overlap = 0, before = 0;
    do {
        v -= dt / 2 * force / m;
        V += dt / 2 * force / M;
        y += dt * v;
        h += dt * V;
        before = overlap;
        overlap = y - h;
        force = k * overlap;
        v -= dt / 2 * force / m;
        V += dt / 2 * force / M;
        t += dt;
    } while (overlap > 0);
    const double end = t - dt + dt * before / (before - overlap);
    const auto exact = plate_bounce({.stiffness = k,
                                     .grain_mass = m,
                                     .plate_mass = M,
                                     .grain_velocity = 2,
                                     .plate_velocity = -0.7});
    BOOST_TEST(exact.contact_time == end, tt::tolerance(1e-8));
    // The last step ends up to dt after the contact, where the spring pulls a little.
    BOOST_TEST(exact.grain_velocity == v, tt::tolerance(1e-7));
    BOOST_TEST(exact.plate_velocity == V, tt::tolerance(1e-7));
}

BOOST_AUTO_TEST_CASE(rejects_parameters_out_of_range) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const PlateImpact bad : {PlateImpact{.stiffness = 0, .grain_mass = 1},
                                  PlateImpact{.stiffness = 1, .grain_mass = 0},
                                  PlateImpact{.stiffness = 1, .grain_mass = infinite},
                                  PlateImpact{.stiffness = 1, .grain_mass = 1, .plate_mass = 0}}) {
        BOOST_CHECK_THROW(static_cast<void>(plate_bounce(bad)), std::domain_error);
    }
}
