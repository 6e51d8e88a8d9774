// Energy loss by particles at rest: a relaxation of known time and height, and one that never ends.
#include "cases/measure/gas/gas_energy.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

scene::GasSampling sampling() {
    scene::GasSampling gas{
        .length = 320, .width = 10, .bin = 32, .replicas = 32, .steps = 4000, .every = 10};
    gas.fields.rests = true;
    return gas;
}

// `rests` particles at rest in every bin of 320 sites, and noise of one.
measure::Results with_rests(const std::function<double(double)>& rests) {
    measure::GasEnergy energy(sampling());
    return run_gas(sampling(), energy, [&](SyntheticGas& gas) {
        const double mean = rests(static_cast<double>(gas.step));
        for (std::size_t i = 0; i < gas.rests.size(); ++i) {
            const double noise = white(static_cast<std::uint64_t>(gas.step), i);
            gas.rests[i] = static_cast<std::uint16_t>(std::lround(std::max(0.0, mean + noise)));
        }
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_relaxation_of_known_time) {
    const auto results = with_rests([](double t) { return 10 + 100 * (1 - std::exp(-t / 300)); });
    BOOST_TEST(get(results, "rests_per_site").value == 110.0 / 320, tt::tolerance(1e-3));
    BOOST_TEST(get(results, "energy_loss_late").value == 100.0 / 320, tt::tolerance(1e-3));
    BOOST_TEST(get(results, "energy_loss_saturates").value == 1.0);
    // 1 - exp(-t/300) = .9 at t = 691; stretches of 80 steps, of which the one with its middle
    // after that is the first.
    BOOST_TEST(std::abs(get(results, "energy_saturation_time").value - 691) <= 80);
    BOOST_TEST(column(results, "energy-loss", "loss").front() == 0.0);
}

BOOST_AUTO_TEST_CASE(a_loss_that_goes_on_is_not_saturated) {
    const auto results = with_rests([](double t) { return 10 + t / 40; });
    BOOST_TEST(get(results, "energy_loss_saturates").value == 0.0);
    // Means of the last two quarters: 87.5 and 62.5 per bin.
    BOOST_TEST(get(results, "energy_loss_drift").value == 1 - 62.5 / 87.5, tt::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(an_overshoot_is_not_saturation) {
    const auto results = with_rests(
        [](double t) { return 10 + 100 * (1 - std::exp(-t / 20)) * (1 + std::exp(-t / 600)); });
    // Within 10 % only from t = 600 ln 10 = 1382 on.
    BOOST_TEST(std::abs(get(results, "energy_saturation_time").value - 1382) <= 80);
}

BOOST_AUTO_TEST_CASE(a_gain_has_no_saturation_time) {
    const auto results = with_rests([](double t) { return 100 - 50 * (1 - std::exp(-t / 300)); });
    BOOST_TEST(get(results, "energy_loss_saturates").value == 0.0);
    BOOST_TEST(!find(results, "energy_saturation_time"));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_measured_is_refused) {
    auto without = sampling();
    without.fields.rests = false;
    BOOST_CHECK_THROW(measure::GasEnergy{without}, std::invalid_argument);
    auto brief = sampling();
    brief.steps = 60;
    BOOST_CHECK_THROW(measure::GasEnergy{brief}, std::invalid_argument);
}
