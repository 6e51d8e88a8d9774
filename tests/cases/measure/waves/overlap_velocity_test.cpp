// Velocity by maximal overlap of known waves, the coverage of its error, and records in which
// nothing travels.
#include "cases/measure/waves/overlap_velocity.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_record.hpp"

#include <boost/test/unit_test.hpp>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

const measure::OverlapOptions plain{
    .lags = {10, 15, 20, 25, 30}, .smoothing = 4, .band = {0, 10}, .expected = std::nullopt};

measure::Results overlap_of(const SyntheticRecord& record, measure::OverlapOptions o = plain) {
    measure::OverlapVelocity overlap(record.description(), std::move(o));
    for (std::size_t t = 0; t + 30 < record.points(); t += 5) {
        const auto reference = overlap.smoothed(record.field(t));
        overlap.add(0, reference, reference);
        for (std::size_t k = 0; k < plain.lags.size(); ++k)
            overlap.add(k + 1, reference, overlap.smoothed(record.field(t + plain.lags[k])));
    }
    measure::Results results;
    (void)overlap.append_share(results);
    overlap.append_velocity(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(velocities_of_known_waves_within_their_stated_errors) {
    int within_two = 0, records = 0;
    double bias = 0;
    for (const double velocity : {0.7, -0.4}) {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            SyntheticRecord record({40, 8}, 100);
            record.noise(20, 0, seed).wave(10, velocity, 1, 1e-4, seed);
            const auto v = get(overlap_of(record), "overlap_velocity");
            bias += (v.value / velocity - 1) / 100;
            within_two += std::abs(v.value - velocity) < 2 * v.standard_error ? 1 : 0;
            ++records;
        }
    }
    BOOST_TEST_MESSAGE("within two errors: " << within_two << " of " << records << ", bias "
                                             << bias);
    BOOST_TEST(std::abs(bias) < 0.02);
    BOOST_TEST(within_two >= 85);  // Student's t of 7 degrees: 91 of 100
}

BOOST_AUTO_TEST_CASE(white_noise_and_a_static_profile_do_not_travel) {
    int found = 0;
    double share = 0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        SyntheticRecord noise({40, 2}, 36);
        noise.noise(20, 0, seed);
        const auto results = overlap_of(noise);
        found += find(results, "overlap_velocity") ? 1 : 0;
        share += get(results, "overlap_wave_fraction").value / 1000;
    }
    BOOST_TEST_MESSAGE("white noise: " << found << " velocities in 1000 records, share of samples "
                                       << share);
    // (2 4/40)^3 = 0.008 is the estimate; the line's intercept is free too.
    BOOST_TEST(found <= 20);
    BOOST_TEST(share < 0.02);
    SyntheticRecord still({40, 8}, 100);
    still.noise(5, 0, 3).wave(50, 0);
    BOOST_TEST(!find(overlap_of(still), "overlap_velocity"));
    BOOST_TEST(get(overlap_of(still), "overlap_wave_fraction").value == 0.0);
}

BOOST_AUTO_TEST_CASE(what_is_expected_decides_between_waves_that_look_alike) {
    SyntheticRecord record({40, 8}, 100);
    record.noise(5, 0, 2).wave(20, 0.7).wave(5, -0.6);
    BOOST_TEST(std::abs(get(overlap_of(record), "overlap_velocity").value - 0.7) < 0.05);
    SyntheticRecord fast({40, 8}, 100);  // after ten intervals 21 of 40, or -19
    fast.noise(5, 0, 2).wave(20, 2.1);
    auto o = plain;
    o.expected = {{1.9, 15}};
    BOOST_TEST(std::abs(get(overlap_of(fast, o), "overlap_velocity").value - 2.1) < 0.05);
    BOOST_TEST(!find(overlap_of(fast), "overlap_velocity"));
}

// Three of eight samples have a wave, the others a much stronger pattern at rest.
BOOST_AUTO_TEST_CASE(where_some_samples_only_have_a_wave_its_velocity_is_theirs) {
    SyntheticRecord record({40, 8}, 100);
    record.noise(5, 0, 2);
    for (std::size_t s = 0; s < 8; ++s)
        record.wave_in(s, s < 3 ? 20 : 100, s < 3 ? 0.7 : 0.0);
    const auto results = overlap_of(record);
    BOOST_TEST(get(results, "overlap_wave_fraction").value == 3.0 / 8);
    const auto v = get(results, "overlap_velocity");
    BOOST_TEST(v.n == 3U);
    BOOST_TEST(std::abs(v.value - 0.7) < 0.02);
}

BOOST_AUTO_TEST_CASE(a_pattern_outside_the_band_and_too_few_intervals) {
    SyntheticRecord record({40, 8}, 100);
    record.noise(5, 0, 2).wave(20, 0.7);
    auto o = plain;
    o.band = {0.1, 0.5};
    BOOST_TEST(!find(overlap_of(record, o), "overlap_velocity"));
    o.lags = {10, 20};
    BOOST_CHECK_THROW(measure::OverlapVelocity(record.description(), o), std::invalid_argument);
    o = plain;
    o.smoothing = 20;
    BOOST_CHECK_THROW(measure::OverlapVelocity(record.description(), o), std::invalid_argument);
}
