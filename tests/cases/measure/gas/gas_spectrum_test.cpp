// The spectrum of white noise is flat and integrates to its variance, waves are found at their
// velocity, and white noise has none; a series that is too short is refused.
#include "cases/measure/gas/gas_spectrum.hpp"

#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

using namespace crossgrain;
using tests::SyntheticGas;

namespace {

scene::GasSampling sampling(int replicas = 8) {
    return {.length = 220,
            .width = 11,
            .bin = 10,
            .replicas = replicas,
            .steps = 10 * (2 * 2048),
            .every = 10,
            .fields = {}};
}

measure::GasSpectrumOptions options() {
    return {.segments = 2, .points = 2048, .f_min = 2e-3, .f_max = 2e-2};
}

struct Wave {
    double amplitude = 0, velocity = 0;
};

/// n = 500 + white noise of deviation 20 + wave, the noise told apart by seed.
measure::Results measured(const scene::GasSampling& s, const measure::GasSpectrumOptions& o,
                          std::uint64_t seed, Wave wave = {}) {
    measure::GasSpectrum spectrum(s, o);
    std::uint64_t n = 0;
    return tests::run_gas<measure::GasSpectrum>(s, spectrum, [&](SyntheticGas& gas) {
        const auto t = static_cast<double>(gas.step);
        gas.fill([&](std::size_t bin, std::size_t) {
            const double x = (static_cast<double>(bin) + 0.5) * 10;
            return 500 + 20 * tests::white(seed, n++) +
                   wave.amplitude * std::cos(2 * std::numbers::pi * (x - wave.velocity * t) / 220);
        });
    });
}

std::optional<measure::Measurement> find(const measure::Results& results, const std::string& name) {
    for (const auto& m : results.measurements) {
        if (m.observable == name) return m;
    }
    return std::nullopt;
}

void check_refused(const scene::GasSampling& s, const measure::GasSpectrumOptions& o,
                   const std::string& part) {
    BOOST_CHECK_EXCEPTION(measure::GasSpectrum(s, o), std::invalid_argument, [&](const auto& e) {
        return std::string(e.what()).find(part) != std::string::npos;
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(white_noise_has_exponent_zero_its_variance_and_no_wave) {
    const auto results = measured(sampling(), options(), 1);
    const auto alpha = find(results, "alpha");
    BOOST_TEST_REQUIRE(alpha.has_value());
    BOOST_TEST(std::abs(alpha->value) < 4 * alpha->standard_error);
    BOOST_TEST(alpha->standard_error > 0.005);
    BOOST_TEST(alpha->standard_error < 0.05);
    BOOST_TEST(alpha->systematic > 0);
    BOOST_TEST(!find(results, "wave_velocity").has_value());
    BOOST_TEST(find(results, "wave_fraction")->value == 0);
    // Mean of the one-sided P = 2 sigma^2, sigma^2 = 400 + 1/12 from rounding.
    double mean = 0;
    const auto& p = results.series.at(0).values.at(1);
    for (const double value : p)
        mean += value / static_cast<double>(p.size());
    BOOST_TEST(std::abs(mean / 800 - 1) < 0.01);
}

BOOST_AUTO_TEST_CASE(a_wave_is_found_at_its_velocity_with_and_against_gravity_alike) {
    for (const double velocity : {0.25, 0.36, 0.5, -0.36}) {
        const auto results = measured(sampling(), options(), 2, {5, velocity});
        const auto v = find(results, "wave_velocity");
        BOOST_TEST_REQUIRE(v.has_value());
        // Half a frequency step is .0054; the centroid is better.
        BOOST_TEST(std::abs(v->value - velocity) < 0.01 * std::abs(velocity));
        BOOST_TEST(std::abs(v->systematic - 0.5 * 220 / (10 * 2048.0)) < 1e-12);
        BOOST_TEST(find(results, "wave_fraction")->value == 1);
    }
}

BOOST_AUTO_TEST_CASE(a_wave_outside_the_band_of_velocities_is_none) {
    const auto results = measured(sampling(), options(), 3, {10, 0.9});
    BOOST_TEST(!find(results, "wave_velocity").has_value());
}

BOOST_AUTO_TEST_CASE(the_fit_window_ends_below_a_slow_wave) {
    auto o = options();
    o.f_max = 0.03;
    const auto results = measured(sampling(), o, 4, {20, 0.36});  // at f = .0164
    const auto alpha = find(results, "alpha");
    BOOST_TEST_REQUIRE(alpha.has_value());
    BOOST_TEST(std::abs(alpha->settings.at("f_max") - 0.7 * 0.36 * 10 / 220) < 2e-4);
    BOOST_TEST(std::abs(alpha->value) < 0.15);
}

BOOST_AUTO_TEST_CASE(white_noise_gives_no_wave_in_at_least_99_of_100_seeds) {
    int waves = 0;
    auto s = sampling(1);
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        waves += find(measured(s, options(), 100 + seed), "wave_velocity").has_value();
    }
    BOOST_TEST(waves <= 1);
}

BOOST_AUTO_TEST_CASE(some_bins_can_be_looked_at_alone) {
    auto o = options();
    o.first_bin = o.last_bin = 20;
    measure::GasSpectrum spectrum(sampling(), o);
    std::uint64_t n = 0;
    const auto results =
        tests::run_gas<measure::GasSpectrum>(sampling(), spectrum, [&](SyntheticGas& gas) {
            gas.fill([&](std::size_t bin, std::size_t) {
                return bin == 20 ? 500 + 20 * tests::white(7, n++) : 3;
            });
        });
    BOOST_TEST(find(results, "alpha").has_value());
}

BOOST_AUTO_TEST_CASE(a_pipe_without_change_has_no_exponent_and_an_open_one_no_wave) {
    auto s = sampling();
    measure::GasSpectrum still(s, options());
    const auto nothing = tests::run_gas<measure::GasSpectrum>(s, still, [](SyntheticGas& gas) {
        gas.fill([](std::size_t, std::size_t) { return 110; });
    });
    BOOST_TEST(find(nothing, "wave_fraction")->value == 0);
    BOOST_TEST(nothing.measurements.size() == 1U);
    s.periodic = false;
    const auto open = measured(s, options(), 5, {20, 0.36});
    BOOST_TEST(!find(open, "wave_velocity").has_value());
    BOOST_TEST(!find(open, "wave_fraction").has_value());
    BOOST_TEST(find(open, "alpha").has_value());
}

BOOST_AUTO_TEST_CASE(a_run_that_ends_early_says_nothing) {
    measure::GasSpectrum spectrum(sampling(), options());
    SyntheticGas gas(sampling());
    for (int f = 0; f < 3000; ++f)
        spectrum.add(gas.view());
    measure::Results results;
    spectrum.finish(results);
    BOOST_TEST(results.measurements.empty());
    BOOST_TEST(results.series.empty());
}

BOOST_AUTO_TEST_CASE(options_without_meaning_are_refused) {
    auto o = options();
    o.segments = 3;
    check_refused(sampling(), o, "the series of 4097 frames is shorter than 3 segments of 2048");
    o = options();
    o.points = 2047;
    check_refused(sampling(), o, "even number of points");
    o = options();
    o.f_min = 0.02;
    check_refused(sampling(), o, "f_min < f_max");
    o = options();
    o.last_bin = 22;
    check_refused(sampling(), o, "< 22 bins");
    o = options();
    o.v_max = 0.1;
    check_refused(sampling(), o, "v_min < v_max");
    auto s = sampling();
    s.fields.count = false;
    check_refused(s, options(), "no field \"count\"");
}
