// Outflows that are known: constant, like a fluid, ended.
#include "cases/measure/hopper/hopper_flow.hpp"

#include "tests/cases/measure/hopper_frames.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

/// `rate(filling, iteration, replica)` grains leave a hopper of 20 sites at the outlet.
measure::Results run(std::int64_t iterations, const std::function<double(double, int, int)>& rate,
                     measure::HopperFlowOptions options = {}) {
    const auto scene = hopper_scene(20, 200, 36.87, 4, iterations, iterations);
    measure::HopperFlow estimator(scene, options);
    for (int r = 0; r < scene.replicas; ++r) {
        HopperFilling filling(scene, [](auto, auto) { return std::uint8_t{1}; });
        const double sites = static_cast<double>(filling.state.size());
        double left = sites;
        for (int i = 0; i < iterations; ++i) {
            const double grains = std::min(left, std::round(rate(left / sites, i, r)));
            filling.flow.push_back(static_cast<std::uint32_t>(grains));
            left -= grains;
        }
        estimator.add(filling.view(scene, r, iterations));
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_constant_flow_has_exponent_zero) {
    // 200 levels hold about 7,900 sites: 20 per iteration empty it in 395.
    const auto results =
        run(500, [](double filling, int, int) { return filling > 0.2 ? 20.0 : 2.0; });
    BOOST_TEST(get(results, "flow_rate").value == 20.0);
    BOOST_TEST(get(results, "flow_rate").standard_error == 0.0);
    BOOST_TEST(std::abs(get(results, "flow_exponent").value) < 1e-12);
    BOOST_TEST(get(results, "filling_at_first_loss").value == 0.2, tt::tolerance(0.02));
    BOOST_TEST(!find(results, "residue"));  // it still flows
    BOOST_TEST(state_found(results).empty());
}

BOOST_AUTO_TEST_CASE(a_flow_that_follows_the_filling_is_told_from_a_constant_one) {
    const auto results =
        run(800, [](double filling, int, int) { return 200 * std::sqrt(filling) / 10; });
    // Whole grains round the rate to 2 %.
    BOOST_TEST(get(results, "flow_exponent").value == 0.5, tt::tolerance(0.05));
    BOOST_TEST(get(results, "flow_rate").value < 18);
}

BOOST_AUTO_TEST_CASE(what_stays_when_the_flow_has_ended_is_the_residue) {
    const auto results =
        run(800, [](double filling, int, int) { return filling > 0.4 ? 20.0 : 0.0; });
    BOOST_TEST(get(results, "residue").value == 0.4, tt::tolerance(0.02));
    BOOST_TEST(state_found(results) == "no meaning");
    const auto emptied = run(800, [](double, int, int) { return 20.0; });
    BOOST_TEST(get(emptied, "residue").value == 0.0);
    BOOST_TEST(state_found(emptied) == "ok");
    BOOST_TEST(get(results, "filling_at_first_loss").value == 0.4, tt::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(a_run_that_hardly_empties_tells_no_exponent) {
    const auto results = run(50, [](double, int, int) { return 20.0; });
    BOOST_TEST(get(results, "flow_rate").value == 20.0);
    BOOST_TEST(!find(results, "flow_exponent"));
    BOOST_TEST(!find(results, "filling_at_first_loss"));
}

BOOST_AUTO_TEST_CASE(the_error_is_the_scatter_of_replicas) {
    const auto results = run(100, [](double, int, int replica) { return 17.0 + 2 * replica; });
    BOOST_TEST(get(results, "flow_rate").value == 20.0, tt::tolerance(1e-12));
    // 17, 19, 21, 23: standard deviation sqrt(20/3), four replicas.
    BOOST_TEST(get(results, "flow_rate").standard_error == std::sqrt(20.0 / 3) / 2,
               tt::tolerance(1e-12));
    BOOST_TEST(column(results, "flow", "rate").size() == 100U);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_measured_is_refused) {
    auto scene = hopper_scene(20, 200, 36.87, 1, 10, 10);
    BOOST_CHECK_THROW(measure::HopperFlow(scene, {.down_to = 1}), std::invalid_argument);
    scene.angles = {20, 30};
    BOOST_CHECK_THROW(measure::HopperFlow{scene}, std::invalid_argument);
}
