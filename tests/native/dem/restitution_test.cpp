// Restitution of a head-on collision, e = 0.8 in the continuum: the bias of every scheme, averaged
// over the moment within a step at which the contact begins and over steps that are no fraction of
// the contact time. (An integer t_col/dt makes e look exact when it is not.)
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr double contact_time = 0.1, restitution = 0.8;

double restitution_of(dem::Scheme scheme, double dt, double entry) {
    auto p = free_discs(law_variants[0], dt);
    p.scheme = scheme;
    dem::State pair;
    const double half = 1 + entry * dt / 2;
    add_disc(pair, -half, 0, 0.5, 0);
    add_disc(pair, half, 0, -0.5, 0);
    const auto end = after(p, pair, std::lround(2 * contact_time / dt) + 4);
    return end.vx[1] - end.vx[0];
}

struct Statistics {
    double bias = 0, rms = 0;  ///< of e, in per cent
};

Statistics statistics(dem::Scheme scheme, double dt_over_contact_time) {
    constexpr int entries = 20, steps = 15;
    double sum = 0, squares = 0;
    for (int i = 0; i < entries; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double dt = contact_time * dt_over_contact_time * (0.93 + 0.01 * j);
            const double entry = (i + 0.5) / entries;
            const double e = 100 * (restitution_of(scheme, dt, entry) / restitution - 1);
            sum += e / (entries * steps);
            squares += e * e / (entries * steps);
        }
    }
    return {sum, std::sqrt(squares)};
}

struct Known {
    std::string name;
    dem::Scheme scheme;
    double coarse, fine;  ///< bias in per cent at dt/t_col = 0.1, 0.01
    double coarse_rms;    ///< at 0.1; 0 where unknown
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_bias_of_restitution_is_that_of_an_independent_measurement) {
    // Measured with another implementation, with a few hundred phases.
    const Known known[] = {
        {"explicit Euler", dem::Scheme::explicit_euler, 63, 5.1, 0},
        {"Taguchi", dem::Scheme::taguchi_euler, 28, 2.5, 0},
        {"Verlet, half step", dem::Scheme::verlet_half_step, -0.12, -0.025, 2.05},
        {"semi-implicit Euler", dem::Scheme::semi_implicit_euler, -0.12, -0.025, 2.05},
        {"Verlet, predicted", dem::Scheme::verlet_predicted, -1.0, -0.010, 2.3},
        {"leap-frog, Crank-Nicolson", dem::Scheme::leapfrog_crank_nicolson, 0.12, 0.001, 2.0},
        {"Runge-Kutta", dem::Scheme::runge_kutta_4, -0.008, 0, 1.06},
    };
    for (const auto& k : known) {
        const auto coarse = statistics(k.scheme, 0.1);
        const auto fine = statistics(k.scheme, 0.01);
        BOOST_TEST_MESSAGE(k.name << ": " << coarse.bias << " " << fine.bias << " rms "
                                  << coarse.rms);
        BOOST_TEST_CONTEXT(k.name << ": " << coarse.bias << " " << fine.bias << " rms "
                                  << coarse.rms) {
            BOOST_TEST(std::abs(coarse.bias - k.coarse) < 0.1 + 0.05 * std::abs(k.coarse));
            BOOST_TEST(std::abs(fine.bias - k.fine) < 0.01 + 0.05 * std::abs(k.fine));
            if (k.coarse_rms > 0) BOOST_TEST(std::abs(coarse.rms - k.coarse_rms) < 0.2);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_scatter_of_restitution_is_of_first_order_for_every_scheme) {
    // The dashpot jumps when the contact begins, and no scheme knows when that is.
    for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted,
                              dem::Scheme::leapfrog_crank_nicolson, dem::Scheme::runge_kutta_4}) {
        const double ratio = statistics(scheme, 0.1).rms / statistics(scheme, 0.05).rms;
        BOOST_TEST_CONTEXT("rms falls by " << ratio) {
            BOOST_TEST(ratio > 1.7);
            BOOST_TEST(ratio < 2.7);
        }
    }
}

BOOST_AUTO_TEST_CASE(the_scheme_of_the_paper_cancels_the_dashpot_at_a_certain_step) {
    // It feeds an oscillation omega at the rate omega^2 dt/4; in a pair with omega^2 = 2 k the
    // dashpot takes eta. At dt = 2 eta/k both are equal, for every mode of a lattice at once.
    const auto p = free_discs(law_variants[0], 0);
    const double dt = 2 * p.damping / p.stiffness;
    const auto with = statistics(dem::Scheme::taguchi_euler, dt / contact_time);
    BOOST_TEST_CONTEXT("e is " << restitution * (1 + with.bias / 100)) {
        BOOST_TEST(std::abs(restitution * (1 + with.bias / 100) - 1) < 0.05);
    }
}
