// Limits of the time step against a scan of the Brillouin zone with the scheme's own amplification
// matrix, and against the scheme itself.
#include "reference/analytic/stability_limit.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain::analytic;

namespace {

constexpr double stiffness = 495.96987227912376, damping = 2.2314355131420975;

struct Mode {
    double frequency_squared, damping_rate;
};

// Eigenvalues of D(q), summed bond by bond, for unit mass.
std::array<Mode, 2> modes(double qx, double qy, double k, double eta, Damping variant) {
    double xx = 0, xy = 0, yy = 0, sum = 0;
    for (int j = 0; j < 6; ++j) {
        const double angle = j * std::numbers::pi / 3;
        const double nx = std::cos(angle), ny = std::sin(angle);
        const double weight = 1 - std::cos(qx * nx + qy * ny);
        xx += weight * nx * nx;
        xy += weight * nx * ny;
        yy += weight * ny * ny;
        sum += weight;
    }
    const double half_trace = (xx + yy) / 2;
    const double root = std::sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
    const auto mode = [&](double eigenvalue) {
        const double rate = variant == Damping::full_vector ? eta * sum : eta * eigenvalue;
        return Mode{k * eigenvalue, rate};
    };
    return {mode(half_trace + root), mode(half_trace - root)};
}

// Spectral radius of (x, v) -> kick dt/2, drift dt, force from the new x and the half-step v, kick
// dt/2; the force at the start of the step comes from the previous half-step velocity u, so that
// the map is (x, u) -> (x', u').
double growth(const Mode& mode, double dt) {
    const double trace = 2 - mode.damping_rate * dt - mode.frequency_squared * dt * dt;
    const double determinant = 1 - mode.damping_rate * dt;
    const auto root = std::sqrt(std::complex<double>(trace * trace / 4 - determinant));
    return std::max(std::abs(trace / 2 + root), std::abs(trace / 2 - root));
}

bool zone_is_stable(double k, double eta, Damping variant, double dt) {
    // A grid that holds the middle of an edge, (0, 2 pi/sqrt 3), and the corner, (4 pi/3, 0).
    constexpr int n = 120;
    for (int a = 0; a <= n; ++a) {
        for (int b = 0; b <= n; ++b) {
            const double qx = 4 * std::numbers::pi / 3 * a / n;
            const double qy = 2 * std::numbers::pi / std::numbers::sqrt3 * b / n;
            for (const Mode& mode : modes(qx, qy, k, eta, variant)) {
                if (growth(mode, dt) > 1 + 1e-9) return false;
            }
        }
    }
    return true;
}

double scanned_limit(double k, double eta, Damping variant) {
    double stable = 0, unstable = 1;
    for (int i = 0; i < 50; ++i) {
        const double middle = (stable + unstable) / 2;
        (zone_is_stable(k, eta, variant, middle) ? stable : unstable) = middle;
    }
    return stable;
}

// |x| after many steps of the scheme itself, from rest at x = 1.
double run_scheme(const Mode& mode, double dt) {
    double x = 1, v = 0, force = -mode.frequency_squared;
    for (int step = 0; step < 20000 && std::abs(x) < 1e6; ++step) {
        v += dt / 2 * force;
        x += dt * v;
        force = -mode.frequency_squared * x - mode.damping_rate * v;
        v += dt / 2 * force;
    }
    return std::abs(x);
}

}  // namespace

BOOST_AUTO_TEST_CASE(known_limits_of_the_dense_bed) {
    // Three digits are known.
    const auto tolerance = tt::tolerance(3e-3);
    const auto full = Damping::full_vector;
    BOOST_TEST(2 / largest_lattice_frequency(stiffness, 1) == 0.0367, tolerance);
    BOOST_TEST(lattice_time_step_limit(stiffness, 0, 1, full) == 0.0367, tolerance);
    BOOST_TEST(lattice_time_step_limit(stiffness, damping, 1, full) == 0.0312, tolerance);
    // e = 0.5 with the same t_col.
    const double eta = std::log(2.0) / 0.1;
    const double k = (std::pow(std::numbers::pi / 0.1, 2) + eta * eta) / 2;
    BOOST_TEST(half_step_verlet_limit(largest_lattice_frequency(k, 1), 8 * eta) == 0.0222,
               tolerance);
    // The middle of the zone's edge is not the first mode to go: about 1 % earlier.
    BOOST_TEST(lattice_time_step_limit(k, eta, 1, full) == 0.0220, tolerance);
}

BOOST_AUTO_TEST_CASE(closed_form_is_the_limit_of_the_whole_brillouin_zone) {
    for (const auto variant : {Damping::full_vector, Damping::normal_only}) {
        // From undamped to far beyond critical damping, where the corner of the zone takes over.
        for (const double eta : {0.0, 1.0, damping, 7.0, 20.0, 100.0, 400.0}) {
            BOOST_TEST_CONTEXT("eta " << eta) {
                // The scan may miss the worst wave vector by half a grid step, an error of second
                // order in it; it can only be too large, but for the threshold on growth.
                const double exact = lattice_time_step_limit(stiffness, eta, 1, variant);
                const double scanned = scanned_limit(stiffness, eta, variant);
                BOOST_TEST(exact == scanned, tt::tolerance(1e-4));
                BOOST_TEST(exact < scanned * (1 + 1e-6));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(scales_with_mass) {
    const double one = lattice_time_step_limit(stiffness, damping, 1, Damping::full_vector);
    const double four =
        lattice_time_step_limit(4 * stiffness, 4 * damping, 4, Damping::full_vector);
    BOOST_TEST(one == four, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(scheme_grows_beyond_the_limit_and_not_before) {
    for (const Mode mode : {Mode{100.0, 0.0}, Mode{100.0, 3.0}, Mode{100.0, 40.0}}) {
        const double limit =
            half_step_verlet_limit(std::sqrt(mode.frequency_squared), mode.damping_rate);
        // Near the limit an undamped mode beats with amplitude 1/sqrt(1 - (dt/limit)^2): 23.
        BOOST_TEST(run_scheme(mode, 0.999 * limit) < 50.0);
        BOOST_TEST(run_scheme(mode, 1.001 * limit) > 1e5);
    }
}

BOOST_AUTO_TEST_CASE(rejects_arguments_out_of_range) {
    BOOST_CHECK_THROW(static_cast<void>(half_step_verlet_limit(0, 0)), std::domain_error);
    BOOST_CHECK_THROW(static_cast<void>(half_step_verlet_limit(1, -1)), std::domain_error);
    BOOST_CHECK_THROW(static_cast<void>(largest_lattice_frequency(1, 0)), std::domain_error);
    BOOST_CHECK_THROW(
        static_cast<void>(lattice_time_step_limit(1, std::nan(""), 1, Damping::full_vector)),
        std::domain_error);
}
