// A moving pattern is found at its velocity from the correlation of two places, with errors that
// cover it; white noise and a pattern at rest are not waves.
#include "cases/measure/gas/gas_correlation.hpp"

#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

using namespace crossgrain;
using tests::SyntheticGas;

namespace {

scene::GasSampling sampling() {
    return {.length = 600,
            .width = 5,
            .periodic = false,
            .bin = 10,
            .replicas = 32,
            .steps = 20000,
            .every = 10,
            .fields = {}};
}

/// 100 + noise + bumps of width 20 sites that move at v, at places of each replica's own, on a
/// level that swings slowly.
measure::Results measured(const measure::GasCorrelationOptions& options, double amplitude,
                          double velocity, double swing = 0) {
    const auto s = sampling();
    measure::GasCorrelation correlation(s, options);
    std::uint64_t n = 0;
    return tests::run_gas<measure::GasCorrelation>(s, correlation, [&](SyntheticGas& gas) {
        const auto t = static_cast<double>(gas.step);
        gas.fill([&](std::size_t bin, std::size_t r) {
            const double x = (static_cast<double>(bin) + 0.5) * 10 - velocity * t;
            const double cell = std::floor(x / 100);
            const double place =
                100 * uniform(r + 1, RandomStream::jitter, static_cast<std::uint64_t>(cell + 1e6));
            const double d = (x - 100 * cell - place) / 20;
            return 200 + 5 * tests::white(3, n++) + amplitude * std::exp(-d * d) +
                   swing * std::sin(t / 4000 + static_cast<double>(r));
        });
    });
}

std::optional<measure::Measurement> find(const measure::Results& results, const std::string& name) {
    for (const auto& m : results.measurements) {
        if (m.observable == name) return m;
    }
    return std::nullopt;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_moving_pattern_gives_its_velocity) {
    const auto results = measured({.separation = 20}, 20, 0.34);
    const auto v = find(results, "correlation_velocity");
    BOOST_TEST_REQUIRE(v.has_value());
    BOOST_TEST(std::abs(v->value - 0.34) < 0.01 * 0.34);
    BOOST_TEST(std::abs(v->value - 0.34) < 4 * v->standard_error + 0.001);
    BOOST_TEST(std::abs(find(results, "correlation_time")->value - 200 / 0.34) < 6);
    BOOST_TEST(results.series.size() == 1U);
    BOOST_TEST(results.series[0].values[0].size() == 134U);  // up to T = 200/.15
}

BOOST_AUTO_TEST_CASE(a_running_mean_uncovers_waves_below_a_slow_swing) {
    measure::GasCorrelationOptions options{.separation = 20};
    options.running_mean = 301;
    const auto v = find(measured(options, 20, 0.34, 60), "correlation_velocity");
    BOOST_TEST_REQUIRE(v.has_value());
    BOOST_TEST(std::abs(v->value - 0.34) < 0.01 * 0.34);
}

BOOST_AUTO_TEST_CASE(noise_and_patterns_at_rest_are_no_waves) {
    BOOST_TEST(measured({.separation = 20}, 0, 0).measurements.empty());
    BOOST_TEST(measured({.separation = 20}, 20, 0).measurements.empty());
    BOOST_TEST(measured({.separation = 20}, 20, -0.34).measurements.empty());
}

BOOST_AUTO_TEST_CASE(options_without_meaning_are_refused) {
    const auto refused = [](const scene::GasSampling& s, const measure::GasCorrelationOptions& o) {
        BOOST_CHECK_THROW(measure::GasCorrelation(s, o), std::invalid_argument);
    };
    refused(sampling(), {.separation = 60});
    refused(sampling(), {.separation = 0});
    refused(sampling(), {.separation = 20, .v_min = 0.6, .v_max = 0.5});
    refused(sampling(), {.separation = 1});
    auto s = sampling();
    s.steps = 1000;
    refused(s, {.separation = 20});
    s = sampling();
    s.replicas = 8;
    refused(s, {.separation = 20});
}
