// The density contrast: its white-noise value on binomial noise, and growth where there is some.
#include "cases/measure/gas/gas_contrast.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

#include <numbers>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

scene::GasSampling sampling() {
    return {.length = 320, .width = 11, .bin = 10, .replicas = 64, .steps = 990, .every = 10};
}

// Each bin holds 110 particles on average (rho = 1), plus a wave of the given amplitude.
measure::Results with_wave(const std::function<double(double)>& amplitude) {
    measure::GasContrast contrast(sampling());
    const double sigma = std::sqrt(110 * (1 - 1.0 / 6));
    return run_gas(sampling(), contrast, [&](SyntheticGas& gas) {
        const double a = amplitude(static_cast<double>(gas.step));
        gas.fill([&](std::size_t i, std::size_t r) {
            const double phase = 2 * std::numbers::pi * static_cast<double>(i) / 4;
            const auto at = static_cast<std::uint64_t>(gas.step);
            return 110 + a * std::sin(phase) + sigma * white(at, i * 64 + r);
        });
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(binomial_noise_has_the_white_value_and_does_not_grow) {
    const auto results = with_wave([](double) { return 0.0; });
    const auto late = get(results, "contrast_late");
    BOOST_TEST(late.settings.at("white") ==
                   2 / std::sqrt(std::numbers::pi) * std::sqrt(5.0 / 6 / 110),
               tt::tolerance(1e-3));
    BOOST_TEST(late.value == late.settings.at("white"), tt::tolerance(0.01));
    const auto growth = get(results, "contrast_growth");
    BOOST_TEST(std::abs(growth.value) < 4 * growth.standard_error);
    BOOST_TEST(growth.n == 64U);
    BOOST_TEST(std::abs(get(results, "contrast_excess").value) < 0.01);
    // The curve is Eq. (1): K times the value per bin.
    BOOST_TEST(column(results, "contrast", "C").back() == 32 * late.value, tt::tolerance(0.1));
    BOOST_TEST(column(results, "contrast", "C_white").back() == 32 * late.settings.at("white"),
               tt::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(a_wave_that_rises_is_growth) {
    const auto results = with_wave([](double step) { return step > 300 ? 30.0 : 0.0; });
    BOOST_TEST(get(results, "contrast_grows").value == 1.0);
    const auto growth = get(results, "contrast_growth");
    BOOST_TEST(growth.value > 10 * growth.standard_error);
}

BOOST_AUTO_TEST_CASE(a_wave_that_dies_is_none) {
    const auto results = with_wave([](double step) { return step > 300 ? 0.0 : 30.0; });
    BOOST_TEST(get(results, "contrast_grows").value == 0.0);
    BOOST_TEST(get(results, "contrast_growth").value < 0);
}

BOOST_AUTO_TEST_CASE(a_run_that_ended_early_has_a_curve_only) {
    measure::GasContrast contrast(sampling());
    SyntheticGas gas(sampling());
    contrast.add(gas.view());  // an empty pipe, too
    measure::Results results;
    contrast.finish(results);
    BOOST_TEST(results.measurements.empty());
    BOOST_TEST(column(results, "contrast", "C").at(0) == 0.0);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_measured_is_refused) {
    auto without = sampling();
    without.fields.count = false;
    BOOST_CHECK_THROW(measure::GasContrast{without}, std::invalid_argument);
    auto two = sampling();
    two.bin = 160;
    BOOST_CHECK_THROW(measure::GasContrast{two}, std::invalid_argument);
}
