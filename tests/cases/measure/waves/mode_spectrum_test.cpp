// Velocity of waves by their peak: known waves in noise of any exponent, the coverage of the stated
// error, and the rate of false alarms of noise, which must be the stated one.
#include "cases/measure/waves/mode_spectrum.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_record.hpp"

#include <boost/test/unit_test.hpp>

using namespace crossgrain;
using namespace crossgrain::tests;
using measure::ModeSpectrum;

namespace {

constexpr measure::SpeedBand band{0, 4};

ModeSpectrum spectrum_of(const SyntheticRecord& record) {
    ModeSpectrum modes(record.description(), record.points(), band);
    modes.add(record.segment());
    return modes;
}

/// Records of noise, of so many, that have a wave.
int false_alarms(double alpha, std::size_t samples, std::size_t points, int records) {
    int found = 0;
    for (int i = 0; i < records; ++i) {
        SyntheticRecord record({10, samples}, points);
        record.noise(50, alpha, static_cast<std::uint64_t>(i + 1));
        found += spectrum_of(record).wave() ? 1 : 0;
    }
    BOOST_TEST_MESSAGE("alpha " << alpha << ", " << samples << " samples of " << points << ": "
                                << found << " waves in " << records << " records of noise");
    return found;
}

}  // namespace

// Stated is 1 in 1000; 4 or more would come by chance in 2 of 100 such tests.
BOOST_AUTO_TEST_CASE(noise_of_any_exponent_has_a_wave_in_one_of_a_thousand_records) {
    BOOST_TEST(false_alarms(0, 1, 512, 1000) <= 3);
    BOOST_TEST(false_alarms(1, 1, 512, 1000) <= 3);
    BOOST_TEST(false_alarms(1.86, 1, 512, 1000) <= 3);
    BOOST_TEST(false_alarms(0, 32, 256, 100) == 0);
    BOOST_TEST(false_alarms(1.86, 32, 256, 100) == 0);
}

BOOST_AUTO_TEST_CASE(waves_are_found_at_their_velocity_in_both_directions) {
    for (const double alpha : {0.0, 1.86}) {
        for (const double velocity : {0.5, -0.3, 1.5}) {
            SyntheticRecord record({20, 4}, 1024);
            record.noise(20, alpha, 7).wave(15, velocity);
            measure::Results results;
            const auto wave = spectrum_of(record).append_wave(results);
            BOOST_TEST_REQUIRE(wave.has_value());
            BOOST_TEST(wave->k == 1U);
            const auto measured = get(results, "wave_velocity");
            BOOST_TEST(measured.systematic == 0.5 * 20 / 1024.0);
            BOOST_TEST(std::abs(measured.value - velocity) < measured.systematic);
            BOOST_TEST(measured.settings.at("peak_sigmas") > 5);
        }
    }
}

// A wave whose phase is lost within 100 intervals: a broad peak.
BOOST_AUTO_TEST_CASE(a_wave_that_loses_its_phase_is_found_within_its_stated_error) {
    for (const std::size_t samples : {1U, 8U}) {
        int found = 0, within_one = 0, within_two = 0;
        double sum = 0;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            SyntheticRecord record({12, samples}, 1024);
            record.noise(10, 0, seed).wave(10, 0.6, 1, 0.02, seed);
            measure::Results results;
            if (!spectrum_of(record).append_wave(results)) continue;
            const auto v = get(results, "wave_velocity");
            ++found;
            sum += v.value - 0.6;
            within_one += std::abs(v.value - 0.6) < v.standard_error ? 1 : 0;
            within_two += std::abs(v.value - 0.6) < 2 * v.standard_error ? 1 : 0;
        }
        BOOST_TEST_MESSAGE(samples << " samples: " << found << " of 100 found, bias "
                                   << sum / found / 0.6 << ", within one error " << within_one
                                   << ", within two " << within_two);
        BOOST_TEST(found >= 95);
        BOOST_TEST(std::abs(sum / found) < 0.01 * 0.6);
        BOOST_TEST(within_two >= 0.85 * found);
    }
}

BOOST_AUTO_TEST_CASE(of_two_waves_the_stronger_one_is_taken) {
    SyntheticRecord record({20, 4}, 1024);
    record.noise(10, 0, 3).wave(10, 0.5).wave(20, 1.2, 2);
    const auto wave = spectrum_of(record).wave();
    BOOST_TEST_REQUIRE(wave.has_value());
    BOOST_TEST(wave->k == 2U);
    BOOST_TEST(std::abs(wave->velocity - 1.2) < 0.01);
    SyntheticRecord same({20, 4}, 1024);
    same.noise(10, 0, 3).wave(10, 0.5).wave(20, -0.8);
    BOOST_TEST(std::abs(spectrum_of(same).wave()->velocity + 0.8) < 0.01);
}

BOOST_AUTO_TEST_CASE(a_static_profile_and_a_wave_beyond_the_band_are_none) {
    SyntheticRecord still({20, 4}, 1024);
    still.noise(10, 0, 5).wave(50, 0);
    BOOST_TEST(!spectrum_of(still).wave().has_value());
    SyntheticRecord fast({20, 4}, 1024);
    fast.noise(10, 0, 5).wave(50, 6);
    BOOST_TEST(!spectrum_of(fast).wave().has_value());
}

BOOST_AUTO_TEST_CASE(records_too_short_say_nothing_and_too_few_bins_are_refused) {
    SyntheticRecord brief({20, 1}, 16);
    brief.noise(1, 0, 1).wave(100, 2);
    BOOST_TEST(!spectrum_of(brief).wave().has_value());
    SyntheticRecord coarse({8, 1}, 64);
    BOOST_CHECK_THROW(ModeSpectrum(coarse.description(), 64, band), std::invalid_argument);
}
