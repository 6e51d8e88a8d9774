// Clogging: pipes that fill and flow, pipes that go on filling, and a mixture of both.
#include "cases/measure/gas/gas_total.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

scene::GasSampling sampling() {
    scene::GasSampling gas{.length = 200,
                           .width = 5,
                           .periodic = false,
                           .bin = 10,
                           .replicas = 40,
                           .steps = 8000,
                           .every = 10};
    gas.fields.momentum = true;
    return gas;
}

// Bins fill to 25 within 200 steps; the first `clogging` replicas then gain `rate` per step.
measure::Results filling(std::size_t clogging, double rate) {
    measure::GasTotal total(sampling(), {});
    return run_gas(sampling(), total, [&](SyntheticGas& gas) {
        const auto t = static_cast<double>(gas.step);
        gas.fill([&](std::size_t i, std::size_t r) {
            const double noise = 2 * white(static_cast<std::uint64_t>(gas.step), i * 40 + r);
            return 25 * std::min(1.0, t / 200) + (r < clogging ? rate * t : 0.0) + noise;
        });
        std::ranges::fill(gas.momentum, std::int16_t{50});
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_flowing_pipe_is_not_clogged) {
    const auto results = filling(0, 0);
    BOOST_TEST(get(results, "clogged_fraction").value == 0.0);
    BOOST_TEST(get(results, "number_late").value == 20 * 25.0, tt::tolerance(0.01));
    BOOST_TEST(std::abs(get(results, "number_growth").value) < 0.01);
    // Momentum 50 halves in 10 rows: 2.5 particles cross a row in a step.
    BOOST_TEST(get(results, "outflow").value == 2.5);
    BOOST_TEST(column(results, "number", "N").front() < 100);
}

BOOST_AUTO_TEST_CASE(the_share_of_clogged_pipes_is_found) {
    const auto results = filling(10, 0.002);
    const auto share = get(results, "clogged_fraction");
    BOOST_TEST(share.value == 0.25);
    BOOST_TEST(share.standard_error == std::sqrt(.25 * .75 / 40), tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_saturated_replica_is_clogged_even_if_the_run_ends) {
    measure::GasTotal total(sampling(), {});
    SyntheticGas gas(sampling());
    for (int f = 0; f < 200; ++f) {
        gas.step = 10 * f;
        gas.fill([](std::size_t, std::size_t) { return 25.0; });
        if (f == 199) {
            gas.saturated.assign(40, 0);
            gas.saturated[7] = 1;
        }
        total.add(gas.view());
    }
    measure::Results results;
    total.finish(results);
    BOOST_TEST(get(results, "clogged_fraction").value == 1.0 / 40);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_measured_is_refused) {
    auto periodic = sampling();
    periodic.periodic = true;
    BOOST_CHECK_THROW((measure::GasTotal{periodic, {}}), std::invalid_argument);
    auto brief = sampling();
    brief.steps = 2000;
    BOOST_CHECK_THROW((measure::GasTotal{brief, {}}), std::invalid_argument);
    BOOST_CHECK_THROW((measure::GasTotal{sampling(), {.margin = 0}}), std::invalid_argument);
}
