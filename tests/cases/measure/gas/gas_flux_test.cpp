// Flux against density: a parabola of known slope, and a flux that does not depend on density.
#include "cases/measure/gas/gas_flux.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr double sites = 110;

scene::GasSampling sampling() {
    scene::GasSampling gas{
        .length = 200, .width = 11, .bin = 10, .replicas = 32, .steps = 2000, .every = 10};
    gas.fields.momentum = true;
    return gas;
}

// Densities of 1 +- .15 per site; J(rho) as given, with noise.
measure::Results with_flux(const std::function<double(double)>& flux) {
    measure::GasFlux estimator(sampling(), {});
    return run_gas(sampling(), estimator, [&](SyntheticGas& gas) {
        const auto seed = static_cast<std::uint64_t>(gas.step);
        gas.fill([&](std::size_t i, std::size_t r) {
            return sites * (1 + .15 * white(seed, i * 32 + r));
        });
        for (std::size_t i = 0; i < gas.count.size(); ++i) {
            const double j = flux(gas.count[i] / sites) + .05 * white(seed + 1'000'000, i);
            gas.momentum[i] = static_cast<std::int16_t>(std::lround(2 * sites * j));
        }
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_slope_of_a_parabola_at_the_mean_density) {
    // J = rho (1.4 - rho/2): dJ/drho = 1.4 - rho = .4 at rho = 1.
    const auto results = with_flux([](double rho) { return rho * (1.4 - rho / 2); });
    const auto slope = get(results, "flux_slope");
    BOOST_TEST(std::abs(slope.value - 0.4) < 4 * slope.standard_error);
    BOOST_TEST(slope.standard_error < 0.005);
    // <J> = .9 - variance/2 = .9 - .15^2/2; J over rho with it.
    BOOST_TEST(get(results, "flux").value == 0.9 - .15 * .15 / 2, tt::tolerance(2e-3));
    BOOST_TEST(get(results, "mean_speed").value == 0.9 - .15 * .15 / 2, tt::tolerance(2e-3));
    BOOST_TEST(get(results, "particles_per_site").value == 1.0, tt::tolerance(1e-3));
    const auto rho = column(results, "flux", "rho"), j = column(results, "flux", "J");
    const auto share = column(results, "flux", "share"), err = column(results, "flux", "err");
    for (std::size_t k = 0; k < rho.size(); ++k) {
        if (share[k] < 0.01) continue;
        // The class is as wide as 1/40: its curvature adds less than 1e-4.
        BOOST_TEST(std::abs(j[k] - rho[k] * (1.4 - rho[k] / 2)) < 5 * err[k] + 1e-4);
    }
}

BOOST_AUTO_TEST_CASE(a_flux_that_ignores_the_density_has_no_slope) {
    const auto slope = get(with_flux([](double) { return 0.5; }), "flux_slope");
    BOOST_TEST(std::abs(slope.value) < 4 * slope.standard_error);
}

BOOST_AUTO_TEST_CASE(equal_densities_have_a_flux_but_no_slope) {
    measure::GasFlux estimator(sampling(), {});
    const auto results = run_gas(sampling(), estimator, [](SyntheticGas& gas) {
        gas.fill([](std::size_t, std::size_t) { return 110.0; });
        std::ranges::fill(gas.momentum, std::int16_t{110});
    });
    BOOST_TEST(get(results, "flux").value == 0.5);
    BOOST_TEST(!find(results, "flux_slope"));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_measured_is_refused) {
    BOOST_CHECK_THROW((measure::GasFlux{sampling(), {.window = 0}}), std::invalid_argument);
    auto without = sampling();
    without.fields.momentum = false;
    BOOST_CHECK_THROW((measure::GasFlux{without, {}}), std::invalid_argument);
}
