// Limits of packings from their own matrices: closed forms of pairs, chains and the triangular
// lattice, agreement of the ways to find them, and what has no limit.
#include "reference/analytic/packing_stability.hpp"

#include "reference/analytic/scheme_stability.hpp"
#include "reference/analytic/step_map.hpp"

#include <Eigen/Eigenvalues>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain::analytic;

namespace {

constexpr double k = 495.96987227912376, eta = 2.2314355131420975;  // e = 0.8, t_col = 0.1

constexpr std::array all_schemes{TimeScheme::half_step_verlet,
                                 TimeScheme::predicted_verlet,
                                 TimeScheme::crank_nicolson_leapfrog,
                                 TimeScheme::semi_implicit_euler,
                                 TimeScheme::explicit_euler,
                                 TimeScheme::taguchi_euler,
                                 TimeScheme::runge_kutta_4};

/// A triangular lattice, periodic along x and, without plates, along y; its contacts are closed by
/// `overlap` diameters.
ClosedPacking lattice_packing(int columns, int rows, double overlap) {
    ClosedPacking packing{.diameter = 2, .mass = 1, .stiffness = k, .damping = eta};
    const double spacing = 2 * (1 - overlap), row = spacing * std::numbers::sqrt3 / 2;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            packing.x.push_back(spacing * (i + 0.5 * (j % 2)));
            packing.y.push_back(row * j);
        }
    }
    packing.period_x = spacing * columns;
    packing.period_y = row * rows;
    return packing;
}

/// The same between plates that touch the centres of the outer rows.
ClosedPacking between_plates(int columns, int rows) {
    ClosedPacking packing = lattice_packing(columns, rows, 1e-4);
    packing.period_y.reset();
    packing.plate_stiffness = k;
    packing.bottom = packing.y.front() + 1e-3;
    packing.lid = packing.y.back() - 1e-3;
    return packing;
}

/// n discs in a ring of contacts along x: w^2 = 4 (k/m) sin^2(q/2), the largest one 4 k/m for even
/// n; damping rates likewise.
ClosedPacking ring(int n) {
    ClosedPacking packing{.diameter = 2, .mass = 1, .stiffness = k, .damping = eta};
    packing.damping_acts_on = Damping::normal_only;
    for (int i = 0; i < n; ++i) {
        packing.x.push_back(1.9 * i);
        packing.y.push_back(0);
    }
    packing.period_x = 1.9 * n;
    return packing;
}

/// Spectral radius of the whole map, from its dense matrix. Translations along x have z = 1 twice,
/// which round-off splits: their states are taken out.
double spectral_radius(TimeScheme scheme, const ClosedPacking& packing, double dt) {
    const StepMap map(scheme, packing_matrices(packing), dt);
    const Eigen::Index rows = 2 * static_cast<Eigen::Index>(packing.x.size());
    Eigen::MatrixXd matrix(map.size(), map.size());
    Eigen::VectorXd column;
    for (Eigen::Index j = 0; j < map.size(); ++j) {
        map(Eigen::VectorXd::Unit(map.size(), j), column);
        for (Eigen::Index block = 0; block < map.size(); block += rows) {
            auto along = column(Eigen::seqN(block, rows / 2, 2));
            along.array() -= along.mean();
        }
        matrix.col(j) = column;
    }
    return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

BOOST_AUTO_TEST_CASE(frequencies_of_rings_and_lattices) {
    for (const int n : {4, 40, 400}) {
        const auto frequency = largest_packing_frequency(ring(n));
        BOOST_TEST(frequency.value == std::sqrt(4 * k), tt::tolerance(1e-8));
        BOOST_TEST(frequency.residual <= 1e-8);
    }
    BOOST_TEST(largest_packing_frequency(lattice_packing(12, 8, 1e-6)).value == std::sqrt(6 * k),
               tt::tolerance(1e-8));
    BOOST_TEST(largest_packing_frequency(
                   ClosedPacking{.x = {0}, .y = {0}, .diameter = 2, .mass = 1, .stiffness = k})
                   .value == 0);
}

// In a ring C = (eta/k) K, so that the modes are known and each scheme's limit is that of one.
BOOST_AUTO_TEST_CASE(a_ring_has_the_limit_of_its_modes) {
    constexpr int n = 20;
    for (const auto scheme : all_schemes) {
        double least = 1;
        for (int q = 1; q <= n / 2; ++q) {
            const double w = 2 * std::sqrt(k) * std::sin(std::numbers::pi * q / n);
            least = std::min(least, mode_time_step_limit(scheme, w, eta / k * w * w));
        }
        const auto limit = packing_time_step_limit(scheme, ring(n));
        BOOST_TEST_CONTEXT("scheme " << static_cast<int>(scheme)) {
            BOOST_TEST_REQUIRE(limit.has_value());
            BOOST_TEST(limit->dt == least, tt::tolerance(1e-9));
            BOOST_TEST(std::abs(limit->eigenvalue) == 1, tt::tolerance(1e-8));
            BOOST_TEST(limit->residual < 1e-6);
        }
    }
}

// Twelve columns and eight rows hold the middle of the zone's edge, where the longitudinal mode of
// largest frequency is, and its corner.
BOOST_AUTO_TEST_CASE(packing_of_a_lattice_has_the_limits_of_the_lattice) {
    for (const auto damping : {Damping::full_vector, Damping::normal_only}) {
        ClosedPacking packing = lattice_packing(12, 8, 1e-6);
        packing.damping_acts_on = damping;
        for (const auto scheme : all_schemes) {
            BOOST_TEST_CONTEXT("scheme " << static_cast<int>(scheme)) {
                const auto limit = packing_time_step_limit(scheme, packing);
                BOOST_TEST_REQUIRE(limit.has_value());
                // The grid of wave vectors and its closed form are as good as that.
                BOOST_TEST(limit->dt == lattice_time_step_limit(scheme, k, eta, 1, damping),
                           tt::tolerance(1e-3));
                BOOST_TEST(limit->residual < 1e-6);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(two_discs_and_a_plate) {
    // One pair: w^2 = 2 k, c = 2 eta along the bond; across it full damping alone, which stops
    // explicit schemes later.
    const ClosedPacking pair{
        .x = {0, 1.9}, .y = {0, 0}, .diameter = 2, .mass = 1, .stiffness = k, .damping = eta};
    BOOST_TEST(largest_packing_frequency(pair).value == std::sqrt(2 * k), tt::tolerance(1e-12));
    for (const auto scheme : all_schemes) {
        const auto limit = packing_time_step_limit(scheme, pair);
        BOOST_TEST_REQUIRE(limit.has_value());
        BOOST_TEST(limit->dt == mode_time_step_limit(scheme, std::sqrt(2 * k), 2 * eta),
                   tt::tolerance(1e-9));
        BOOST_TEST(limit->residual < 1e-9);
    }
    // One disc on a plate: its own oscillation, undamped.
    const ClosedPacking on_plate{.x = {0},
                                 .y = {-0.1},
                                 .diameter = 2,
                                 .mass = 1,
                                 .stiffness = k,
                                 .damping = eta,
                                 .plate_stiffness = k,
                                 .bottom = 0.0};
    BOOST_TEST(packing_time_step_limit(TimeScheme::half_step_verlet, on_plate)->dt ==
                   2 / std::sqrt(k),
               tt::tolerance(1e-12));
    BOOST_TEST(packing_time_step_limit(TimeScheme::explicit_euler, on_plate)->dt == 0);
}

// Plates have springs but no dashpots: K and C do not commute. The limit is where the map of the
// whole packing, step by step, begins to have an eigenvalue outside of the unit disc.
BOOST_AUTO_TEST_CASE(the_step_map_turns_unstable_at_the_limit) {
    const ClosedPacking packing = between_plates(12, 4);
    for (const auto scheme : all_schemes) {
        BOOST_TEST_CONTEXT("scheme " << static_cast<int>(scheme)) {
            const auto limit = packing_time_step_limit(scheme, packing);
            BOOST_TEST_REQUIRE(limit.has_value());
            BOOST_TEST(std::abs(limit->eigenvalue) == 1, tt::tolerance(1e-9));
            BOOST_TEST(limit->residual < 1e-9);
            // Round-off of the dense eigenvalues is 1e-13.
            BOOST_TEST(spectral_radius(scheme, packing, 0.9999 * limit->dt) <= 1 + 1e-11);
            BOOST_TEST(spectral_radius(scheme, packing, 1.0001 * limit->dt) > 1 + 1e-11);
        }
    }
}

BOOST_AUTO_TEST_CASE(discs_that_touch_nothing_do_not_count) {
    const ClosedPacking apart{
        .x = {0, 3}, .y = {0, 0}, .diameter = 2, .mass = 1, .stiffness = k, .damping = eta};
    BOOST_TEST(!packing_time_step_limit(TimeScheme::half_step_verlet, apart).has_value());
    ClosedPacking pair = apart;
    pair.x = {0, 50, 1.9};
    pair.y = {0, 0, 0};
    BOOST_TEST(packing_matrices(pair).stiffness.rows() == 4);
}

BOOST_AUTO_TEST_CASE(refuses_bad_packings) {
    ClosedPacking packing = ring(4);
    packing.y.pop_back();
    BOOST_CHECK_THROW((void)packing_matrices(packing), std::invalid_argument);
    packing = ring(4);
    packing.stiffness = 0;
    BOOST_CHECK_THROW((void)packing_matrices(packing), std::domain_error);
    packing = ring(4);
    packing.damping = -1;
    BOOST_CHECK_THROW((void)packing_matrices(packing), std::domain_error);
    BOOST_CHECK_THROW(StepMap(TimeScheme::explicit_euler, packing_matrices(ring(4)), 0),
                      std::domain_error);
}
