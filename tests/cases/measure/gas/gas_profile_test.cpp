// The wave's shape by hierarchical overlap: a saw tooth in noise, and noise alone.
#include "cases/measure/gas/gas_profile.hpp"
#include "cases/measure/waves/wave_profile.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

constexpr measure::GasProfileOptions options{.fields = 256, .groups = 8};

scene::GasSampling sampling() {
    return {.length = 400, .width = 10, .bin = 5, .replicas = 32, .steps = 299, .every = 1};
}

// Rises over `back` sites to the peak at x = 0 and falls over `front` sites: height 1 at the peak.
double triangle(double x, double back, double front) {
    const double wrapped = x - 400 * std::floor(x / 400 + 0.5);
    return std::max(0.0, wrapped < 0 ? 1 + wrapped / back : 1 - wrapped / front);
}

// 50 particles per bin, noise of 5, and a triangle that moves at .36 from a place of its own.
measure::Results moving_triangle(double height, double back, double front) {
    measure::GasProfile profile(sampling(), options);
    return run_gas(sampling(), profile, [&](SyntheticGas& gas) {
        gas.fill([&](std::size_t i, std::size_t r) {
            const double start = 37 * static_cast<double>(r);
            const double x =
                5 * static_cast<double>(i) - start - 0.36 * static_cast<double>(gas.step);
            return 50 + height * triangle(x, back, front) +
                   5 * white(static_cast<std::uint64_t>(gas.step), i * 32 + r);
        });
    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_shape_of_a_profile_without_noise) {
    std::vector<double> profile(80);
    for (std::size_t i = 0; i < 80; ++i)
        profile[i] = triangle(5 * static_cast<double>(i) - 200, 120, 40);
    const auto shape = measure::wave_shape(profile);
    BOOST_TEST_REQUIRE(shape.has_value());
    BOOST_TEST(shape->amplitude == 1.0);
    BOOST_TEST(shape->width * 5 == 80.0, tt::tolerance(1e-12));
    BOOST_TEST(shape->steepness == 3.0, tt::tolerance(1e-12));
    BOOST_TEST(!measure::wave_shape(std::vector<double>(80, 0.0)).has_value());
}

BOOST_AUTO_TEST_CASE(a_moving_triangle_is_found_in_noise) {
    const auto results = moving_triangle(30, 120, 40);
    // The area of the triangle, 30 x 80 of 400 sites, raises the mean by 6 of 56. Shifts by whole
    // bins blunt the tip by up to half a bin of the front: 2.5/40 of 30 particles.
    BOOST_TEST(get(results, "profile_amplitude").value == 24.0 / 56, tt::tolerance(0.08));
    BOOST_TEST(get(results, "profile_excess").value > 0.2);
    // Half way from mean to peak: 40 % of the way down each side.
    BOOST_TEST(get(results, "profile_width").value == 0.4 * 160, tt::tolerance(0.1));
    BOOST_TEST(get(results, "profile_asymmetry").value == std::log(3.0), tt::tolerance(0.25));
    BOOST_TEST(get(results, "profile_front_sharper").value == 1.0);
    const auto x = column(results, "profile", "X");
    const auto density = column(results, "profile", "density");
    const auto top = std::ranges::max_element(density) - density.begin();
    BOOST_TEST(std::abs(x[static_cast<std::size_t>(top)]) <= 5);
}

BOOST_AUTO_TEST_CASE(a_mirrored_triangle_has_the_sharper_back) {
    BOOST_TEST(get(moving_triangle(30, 40, 120), "profile_front_sharper").value == 0.0);
}

BOOST_AUTO_TEST_CASE(noise_makes_a_peak_that_its_null_makes_too) {
    const auto results = moving_triangle(0, 1, 1);
    const auto excess = get(results, "profile_excess");
    BOOST_TEST(get(results, "profile_null_amplitude").value > 0.01);
    BOOST_TEST(std::abs(excess.value) < 4 * excess.standard_error);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_measured_is_refused) {
    auto open = sampling();
    open.periodic = false;
    BOOST_CHECK_THROW((measure::GasProfile{open, options}), std::invalid_argument);
    BOOST_CHECK_THROW((measure::GasProfile{sampling(), {.fields = 300, .groups = 8}}),
                      std::invalid_argument);
    BOOST_CHECK_THROW((measure::GasProfile{sampling(), {.fields = 512, .groups = 8}}),
                      std::invalid_argument);
    BOOST_CHECK_THROW((measure::GasProfile{sampling(), {.fields = 256, .groups = 64}}),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_run_that_ended_early_has_no_profile) {
    measure::GasProfile profile(sampling(), options);
    SyntheticGas gas(sampling());
    profile.add(gas.view());
    measure::Results results;
    profile.finish(results);
    BOOST_TEST(results.measurements.empty());
}
