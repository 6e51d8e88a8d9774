// What a gas of any law conserves or loses: momentum to round-off, energy never upwards, and
// nothing at all without dashpots but the error of the scheme, which falls as dt^2.
#include "tests/native/dem/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

/// The gas in a doubly periodic box at an area fraction of 0.5.
dem::Parameters box(const LawVariant& law, double dt) {
    auto p = free_discs(law, dt);
    p.period_x = p.period_y = 15;
    return p;
}
const dem::State gas = hot_gas(6, 2.5);

struct EnergyRun {
    double start = 0, end = 0;
    double largest_error = 0;  ///< of any step, against the start
    double largest_rise = 0;   ///< within one step
};

EnergyRun follow_energy(const dem::Parameters& p, double duration) {
    dem::Engine engine(p, gas);
    EnergyRun run{.start = pair_energy(p, gas)};
    double before = run.start;
    const std::int64_t steps = std::lround(duration / p.dt);
    for (std::int64_t step = 0; step < steps; ++step) {
        engine.advance(1);
        run.end = pair_energy(p, engine.state());
        run.largest_error = std::max(run.largest_error, std::abs(run.end - run.start));
        run.largest_rise = std::max(run.largest_rise, run.end - before);
        before = run.end;
    }
    return run;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_gas_of_any_law_keeps_its_momentum_to_round_off) {
    const auto start = momentum(box(law_variants[0], 1e-3), gas);
    for (const auto& law : law_variants) {
        for (const auto scheme : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
            auto p = box(law, 1e-3);
            p.scheme = scheme;
            const auto end = momentum(p, after(p, gas, 2000));
            BOOST_TEST_CONTEXT(law.name) {
                // 36 momenta of order 3, each rounded 4000 times at 2e-16, adding up at random.
                BOOST_TEST(std::abs(end[0] - start[0]) < 1e-12);
                BOOST_TEST(std::abs(end[1] - start[1]) < 1e-12);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(central_forces_keep_the_angular_momentum) {
    // The normal law pulls along the line of centres; the full vector law has no such balance
    // without spins.
    const auto angular_momentum = [](const dem::State& s) {
        double sum = 0;
        for (std::size_t i = 0; i < s.x.size(); ++i)
            sum += s.x[i] * s.vy[i] - s.y[i] * s.vx[i];
        return sum;
    };
    for (const auto& law : law_variants) {
        const auto p = free_discs(law, 1e-3);
        const double change = angular_momentum(after(p, gas, 500)) - angular_momentum(gas);
        const bool central = law.damping == dem::DampingDirection::normal_only;
        BOOST_TEST_CONTEXT(law.name << ": " << change) {
            // Sums of order 100, rounded 500 times; the dashpot across the normal makes 0.1 and
            // more.
            BOOST_TEST((std::abs(change) < 1e-11) == central);
        }
    }
}

BOOST_AUTO_TEST_CASE(an_elastic_gas_of_any_law_keeps_its_energy_with_an_error_of_dt_squared) {
    for (const auto& law : law_variants) {
        std::vector<double> errors;
        for (const double dt : {1e-3, 5e-4, 2.5e-4}) {
            auto p = box(law, dt);
            p.damping = 0;
            const auto run = follow_energy(p, 0.25);
            errors.push_back(run.largest_error / run.start);
        }
        BOOST_TEST_CONTEXT(law.name << ": " << errors[0] << " " << errors[1] << " " << errors[2]) {
            // (omega dt)^2/8 of a contact's energy is 1.2e-4 here; not all energy is in contacts.
            BOOST_TEST(errors[0] < 1.2e-4);
            for (std::size_t i = 1; i < errors.size(); ++i) {
                // Whether a step falls on the moment of largest error scatters the order by 0.1.
                BOOST_TEST(std::abs(std::log2(errors[i - 1] / errors[i]) - 2) < 0.25);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(dashpots_of_any_law_never_raise_the_energy) {
    constexpr double dt = 2e-4;
    auto elastic = box(law_variants[0], dt);
    elastic.damping = 0;
    // What the scheme itself gives and takes within a step; a dashpot may add nothing to it.
    const double scheme = follow_energy(elastic, 0.25).largest_rise;
    for (const auto& law : law_variants) {
        for (const auto kind : {dem::Scheme::verlet_half_step, dem::Scheme::verlet_predicted}) {
            auto p = box(law, dt);
            p.scheme = kind;
            const auto run = follow_energy(p, 0.25);
            BOOST_TEST_CONTEXT(law.name << ": " << run.largest_rise << ", elastic " << scheme) {
                BOOST_TEST(run.largest_rise <= 1.1 * scheme);
                // A third of the grains have met once, at 1 - e^2 = 0.36 of the normal part.
                BOOST_TEST(run.end < 0.97 * run.start);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_head_on_collision_of_any_law_loses_what_the_closed_form_says) {
    // e = 0.8 while the tail is kept. Cutting the tail ends the pull: e is larger. With
    // alpha = atan2(2 g w, w^2 - g^2) the cut comes at w t = alpha instead of pi and
    // e = exp(-g alpha / w), g = eta/m, w = pi/t_col (second derivation: Schwager & Poeschel,
    // Granular Matter 9, 465 (2007)).
    const double g = 2.2314355131420975, w = 10 * std::acos(-1.0);
    const double cut = std::exp(-g * (std::acos(-1.0) - std::atan2(2 * g * w, w * w - g * g)) / w);
    for (const auto& law : law_variants) {
        auto p = free_discs(law, 1e-5);
        p.scheme = dem::Scheme::verlet_predicted;
        dem::State pair;
        add_disc(pair, -1.003, 0, 0.5, 0);
        add_disc(pair, 1.003, 0, -0.5, 0);
        const auto end = after(p, pair, 15000);
        const double restitution = end.vx[1] - end.vx[0];
        const double expected = law.tail == dem::AttractiveTail::kept ? 0.8 : cut;
        BOOST_TEST_CONTEXT(law.name) {
            // Entry and exit fall between steps: g dt = 2e-5.
            BOOST_TEST(restitution == expected, tt::tolerance(5e-5));
        }
    }
    BOOST_TEST(cut > 0.8);
}
