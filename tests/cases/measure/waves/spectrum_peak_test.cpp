// A peak is found where it is, on any background; noise and power laws have none.
#include "cases/measure/waves/spectrum_peak.hpp"

#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace crossgrain;
using measure::find_peak;

namespace {

constexpr std::size_t size = 2049;

measure::PeakSearch band(double averages = 1000) {
    return {.first = 100, .last = 400, .degrees = 2 * averages};
}

/// k^-alpha, each value scattered like the mean of `averages` periodograms.
std::vector<double> noise(double alpha, double averages, std::uint64_t seed) {
    std::vector<double> power(size, 1.0);
    for (std::size_t k = 1; k < size; ++k) {
        const double z = normal_pair(seed, RandomStream::jitter, k)[0];
        power[k] =
            std::pow(static_cast<double>(k), -alpha) * std::max(0.01, 1 + z / std::sqrt(averages));
    }
    return power;
}

void add_line(std::vector<double>& power, double k0, double width, double height) {
    for (std::size_t k = 1; k < power.size(); ++k) {
        const double x = (static_cast<double>(k) - k0) / width;
        power[k] *= 1 + height * std::exp(-x * x);
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_line_is_found_at_its_place_on_every_background) {
    for (const double alpha : {0.0, 1.0, 1.86}) {
        for (const double k0 : {120.0, 217.3, 380.0}) {
            auto power = noise(alpha, 1000, 1);
            add_line(power, k0, 3.0, 2.0);
            const auto peak = find_peak(power, band());
            BOOST_TEST_REQUIRE(peak.has_value());
            BOOST_TEST(peak->significant);
            BOOST_TEST(std::abs(peak->k - k0) < 0.3);
            // A mean over the width of the line, whose top is three times the background.
            BOOST_TEST(peak->ratio > 1.8);
            BOOST_TEST(peak->ratio < 3.1);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_broad_peak_fills_its_neighbourhood_and_is_found) {
    for (const double alpha : {0.0, 1.0}) {
        auto power = noise(alpha, 1000, 5);
        add_line(power, 217.3, 20.0, 12.0);
        const auto peak = find_peak(power, band());
        BOOST_TEST_REQUIRE(peak.has_value());
        BOOST_TEST(peak->significant);
        // The power-law background tilts it: by alpha (20/217)^2/2 of k, a part of 0.4 %.
        BOOST_TEST(std::abs(peak->k - 217.3) < 1.5);
    }
}

BOOST_AUTO_TEST_CASE(a_line_with_the_skirts_of_the_window_is_found) {
    // A periodic signal through Bartlett's window: (sin(pi x/2)/(pi x/2))^4 over ten decades.
    std::vector<double> power(size, 1e-6);
    for (std::size_t k = 1; k < size; ++k) {
        const double x = std::numbers::pi / 2 * (static_cast<double>(k) - 186.09);
        power[k] += 1e4 * std::pow(std::sin(x) / x, 4);
    }
    const auto peak = find_peak(power, band());
    BOOST_TEST_REQUIRE(peak.has_value());
    BOOST_TEST(peak->significant);
    BOOST_TEST(std::abs(peak->k - 186.09) < 0.2);
}

BOOST_AUTO_TEST_CASE(a_line_outside_the_band_is_not_taken) {
    auto power = noise(1.0, 1000, 2);
    add_line(power, 600, 3.0, 100.0);
    const auto peak = find_peak(power, band());
    BOOST_TEST_REQUIRE(peak.has_value());
    BOOST_TEST(!peak->significant);
    // Nor the side of a broad one.
    add_line(power, 450, 40.0, 100.0);
    BOOST_TEST(!find_peak(power, band())->significant);
}

BOOST_AUTO_TEST_CASE(noise_has_no_significant_peak) {
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        for (const double averages : {20.0, 1000.0}) {
            const auto power = noise(seed % 2 == 0 ? 0.0 : 1.5, averages, seed);
            found += find_peak(power, band(averages))->significant ? 1 : 0;
        }
    }
    BOOST_TEST(found <= 2);  // of 400, with 0.4 expected
}

BOOST_AUTO_TEST_CASE(a_smooth_spectrum_has_no_peak) {
    std::vector<double> power(size, 1.0);
    for (std::size_t k = 1; k < size; ++k)
        power[k] = std::pow(static_cast<double>(k), -2.0);
    BOOST_TEST(!find_peak(power, band())->significant);
    // Nor has a bend of the exponent, from steep to flat or from flat to steep.
    for (std::size_t k = 200; k < size; ++k)
        power[k] = power[199];
    BOOST_TEST(!find_peak(power, band())->significant);
    for (std::size_t k = 1; k < size; ++k)
        power[k] = k < 200 ? 1.0 : std::pow(static_cast<double>(k) / 200, -3.0);
    BOOST_TEST(!find_peak(power, band())->significant);
}

BOOST_AUTO_TEST_CASE(a_peak_that_is_too_low_is_not_significant_however_sharp) {
    auto power = noise(0.0, 1e8, 3);
    add_line(power, 200, 2.0, 0.2);
    const auto peak = find_peak(power, band(1e6));
    BOOST_TEST(peak->sigmas() > 30);
    BOOST_TEST(!peak->significant);
}

// The same line is beyond doubt in the mean of a thousand periodograms, and nothing in one.
BOOST_AUTO_TEST_CASE(what_is_significant_depends_on_the_degrees_of_freedom_and_the_search) {
    auto power = noise(0.0, 1e6, 6);
    add_line(power, 217, 2.0, 2.0);
    BOOST_TEST(find_peak(power, band(1000))->significant);
    BOOST_TEST(!find_peak(power, band(1))->significant);
    auto search = band(40);
    const double alone = find_peak(power, search)->false_alarm;
    search.spectra = 8;
    BOOST_TEST(std::abs(find_peak(power, search)->false_alarm / alone - 8) < 0.1);
}

BOOST_AUTO_TEST_CASE(a_band_without_room_gives_nothing) {
    const auto power = noise(0.0, 100, 4);
    BOOST_TEST(!find_peak(power, {.first = 1, .last = 4}).has_value());
    BOOST_TEST(!find_peak(power, {.first = 300, .last = 200}).has_value());
    BOOST_TEST(!find_peak(power, {.first = size - 3, .last = size - 1}).has_value());
    BOOST_TEST(!find_peak(std::vector<double>(size, 0.0), band()).has_value());
}
