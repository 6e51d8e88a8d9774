// Spatial structure is found at its wave number and with its exponent; particles without
// correlation have S = 1, exponent 0 and no wave number.
#include "cases/measure/gas/gas_wave_number.hpp"

#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

using namespace crossgrain;
using tests::SyntheticGas;

namespace {

scene::GasSampling sampling(int replicas) {
    return {.length = 640,
            .width = 11,
            .bin = 10,
            .replicas = replicas,
            .steps = 4000,
            .every = 10,
            .fields = {}};
}

/// Mean 400, deviation 20: the variance of Poisson counts, with a pattern of its own per frame.
template <class Pattern>
measure::Results measured(int replicas, Pattern pattern) {
    const auto s = sampling(replicas);
    measure::GasWaveNumber estimator(s, {});
    std::uint64_t n = 0;
    return tests::run_gas<measure::GasWaveNumber>(s, estimator, [&](SyntheticGas& gas) {
        gas.fill([&](std::size_t bin, std::size_t replica) {
            return 400 + 20 * tests::white(11, n++) + pattern(gas.step, bin, replica);
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

BOOST_AUTO_TEST_CASE(particles_without_correlation_have_no_structure) {
    for (const int replicas : {8, 7}) {  // an odd number has a last one without partner
        const auto results =
            measured(replicas, [](std::int64_t, std::size_t, std::size_t) { return 0.0; });
        const auto exponent = find(results, "wave_number_exponent");
        BOOST_TEST_REQUIRE(exponent.has_value());
        BOOST_TEST(std::abs(exponent->value) < 4 * exponent->standard_error);
        BOOST_TEST(!find(results, "wave_number").has_value());
        for (const double s : results.series.at(0).values.at(1))
            BOOST_TEST(std::abs(s - 1) < 0.12);
    }
}

BOOST_AUTO_TEST_CASE(a_wave_is_found_at_its_wave_number) {
    const auto results = measured(8, [](std::int64_t t, std::size_t bin, std::size_t r) {
        const double phase = 0.3 * static_cast<double>(t) + static_cast<double>(r);
        return 10 * std::cos(2 * std::numbers::pi * 3 * static_cast<double>(bin) / 64 - phase);
    });
    const auto k = find(results, "wave_number");
    BOOST_TEST_REQUIRE(k.has_value());
    BOOST_TEST(k->value == 3);
}

BOOST_AUTO_TEST_CASE(the_exponent_of_a_power_law_comes_out) {
    // Fourier modes of amplitude 1/k with random phases: S(k) ~ k^-2.
    const auto results = measured(8, [](std::int64_t t, std::size_t bin, std::size_t r) {
        double sum = 0;
        for (std::uint64_t k = 1; k <= 32; ++k) {
            const double phase =
                uniform(r + 1, RandomStream::jitter, static_cast<std::uint64_t>(t) * 64 + k);
            sum += 2000 / static_cast<double>(k) *
                   std::cos(2 * std::numbers::pi * (static_cast<double>(k * bin) / 64 - phase));
        }
        return sum + 20000;
    });
    const auto exponent = find(results, "wave_number_exponent");
    BOOST_TEST_REQUIRE(exponent.has_value());
    BOOST_TEST(std::abs(exponent->value + 2) < 0.02);
}

BOOST_AUTO_TEST_CASE(options_without_meaning_are_refused) {
    BOOST_CHECK_THROW(measure::GasWaveNumber(sampling(8), {.k_min = 0}), std::invalid_argument);
    BOOST_CHECK_THROW(measure::GasWaveNumber(sampling(8), {.k_max = 33}), std::invalid_argument);
    BOOST_CHECK_THROW(measure::GasWaveNumber(sampling(2), {}), std::invalid_argument);
    auto s = sampling(8);
    s.length = 150;
    BOOST_CHECK_THROW(measure::GasWaveNumber(s, {}), std::invalid_argument);
}
