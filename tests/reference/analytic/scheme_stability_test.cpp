// Limits of the time step against the schemes themselves, run on one mode, and against each other.
#include "reference/analytic/scheme_stability.hpp"

#include "reference/analytic/stability_limit.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain::analytic;

namespace {

constexpr double k = 495.96987227912376, eta = 2.2314355131420975;  // e = 0.8, t_col = 0.1

struct Oscillator {
    double frequency_squared, damping_rate;
    double x = 1, v = 0, a = 0;

    [[nodiscard]] double pull(double at_x, double at_v) const {
        return -frequency_squared * at_x - damping_rate * at_v;
    }
    void step(TimeScheme scheme, double h);
};

void Oscillator::step(TimeScheme scheme, double h) {
    const double a_before = a;
    switch (scheme) {
    case TimeScheme::half_step_verlet:
    case TimeScheme::predicted_verlet:
        v += h / 2 * a;
        x += h * v;
        a = pull(x, scheme == TimeScheme::half_step_verlet ? v : v + h / 2 * a_before);
        v += h / 2 * a;
        break;
    case TimeScheme::crank_nicolson_leapfrog: {
        // v is that of the half step; solved for the new one.
        const double c = damping_rate * h / 2;
        v = ((1 - c) * v - h * frequency_squared * x) / (1 + c);
        x += h * v;
        break;
    }
    case TimeScheme::semi_implicit_euler:
        v += h * pull(x, v);
        x += h * v;
        break;
    case TimeScheme::explicit_euler:
        a = pull(x, v);
        x += h * v;
        v += h * a;
        break;
    case TimeScheme::taguchi_euler:
        a = pull(x, v);
        x += h * v + h * h / 2 * a;
        v += h * a;
        break;
    case TimeScheme::runge_kutta_4: {
        const double x1 = v, v1 = pull(x, v);
        const double x2 = v + h / 2 * v1, v2 = pull(x + h / 2 * x1, v + h / 2 * v1);
        const double x3 = v + h / 2 * v2, v3 = pull(x + h / 2 * x2, v + h / 2 * v2);
        const double x4 = v + h * v3, v4 = pull(x + h * x3, v + h * v3);
        x += h / 6 * (x1 + 2 * x2 + 2 * x3 + x4);
        v += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        break;
    }
    }
}

double size_after(TimeScheme scheme, Oscillator oscillator, double h, int steps) {
    for (int n = 0; n < steps && std::abs(oscillator.x) < 1e9; ++n)
        oscillator.step(scheme, h);
    return std::hypot(oscillator.x * std::sqrt(oscillator.frequency_squared), oscillator.v);
}

constexpr std::array all_schemes{TimeScheme::half_step_verlet,
                                 TimeScheme::predicted_verlet,
                                 TimeScheme::crank_nicolson_leapfrog,
                                 TimeScheme::semi_implicit_euler,
                                 TimeScheme::explicit_euler,
                                 TimeScheme::taguchi_euler,
                                 TimeScheme::runge_kutta_4};

}  // namespace

BOOST_AUTO_TEST_CASE(schemes_grow_beyond_the_limit_and_not_before) {
    for (const auto scheme : all_schemes) {
        // From little to beyond critical damping (20).
        for (const double rate : {2.0, 5.0, 15.0, 25.0, 60.0}) {
            BOOST_TEST_CONTEXT("scheme " << static_cast<int>(scheme) << ", rate " << rate) {
                const Oscillator mode{100.0, rate};
                const double limit = mode_time_step_limit(scheme, 10, rate);
                BOOST_TEST(size_after(scheme, mode, 0.99 * limit, 200000) < 1e-3);
                BOOST_TEST(size_after(scheme, mode, 1.01 * limit, 200000) > 1e6);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(limits_without_damping) {
    for (const auto scheme : {TimeScheme::half_step_verlet, TimeScheme::predicted_verlet,
                              TimeScheme::crank_nicolson_leapfrog}) {
        BOOST_TEST(mode_time_step_limit(scheme, 10, 0) == 0.2, tt::tolerance(1e-14));
    }
    BOOST_TEST(mode_time_step_limit(TimeScheme::explicit_euler, 10, 0) == 0.0);
    BOOST_TEST(mode_time_step_limit(TimeScheme::taguchi_euler, 10, 0) == 0.0);
    BOOST_TEST(mode_time_step_limit(TimeScheme::runge_kutta_4, 10, 0) ==
                   2 * std::numbers::sqrt2 / 10,
               tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(lattice_limits) {
    const auto limit = [](TimeScheme scheme, Damping damping) {
        return lattice_time_step_limit(scheme, k, eta, 1, damping);
    };
    const auto full = Damping::full_vector, normal = Damping::normal_only;
    // The closed forms of the lattice: c/w^2 is least where the mode is purely longitudinal.
    BOOST_TEST(limit(TimeScheme::taguchi_euler, full) == 8 * eta / (3 * k), tt::tolerance(1e-3));
    BOOST_TEST(limit(TimeScheme::explicit_euler, full) == 4 * eta / (3 * k), tt::tolerance(1e-3));
    BOOST_TEST(limit(TimeScheme::taguchi_euler, normal) == 2 * eta / k, tt::tolerance(1e-9));
    BOOST_TEST(limit(TimeScheme::explicit_euler, normal) == eta / k, tt::tolerance(1e-9));
    for (const auto damping : {full, normal}) {
        BOOST_TEST(limit(TimeScheme::half_step_verlet, damping) ==
                       lattice_time_step_limit(k, eta, 1, damping),
                   tt::tolerance(1e-4));
        BOOST_TEST(limit(TimeScheme::crank_nicolson_leapfrog, damping) == 2 / std::sqrt(6 * k),
                   tt::tolerance(1e-6));
    }
}

BOOST_AUTO_TEST_CASE(refuses_what_is_no_mode) {
    BOOST_CHECK_THROW(static_cast<void>(mode_time_step_limit(TimeScheme::half_step_verlet, 0, 1)),
                      std::domain_error);
    BOOST_CHECK_THROW(static_cast<void>(mode_time_step_limit(TimeScheme::half_step_verlet, 1, -1)),
                      std::domain_error);
}
