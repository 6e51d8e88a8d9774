// Exponent of the bins' spectrum: bias, and coverage of the stated error, over records of noise of
// known exponent; its integral is the variance.
#include "cases/measure/waves/bin_spectrum.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_record.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

measure::Results spectrum_of(const SyntheticRecord& record, measure::FrequencyWindow window) {
    const auto shape = record.description().shape;
    measure::BinSpectrum spectrum({0, shape.bins - 1}, shape.samples, record.points());
    auto segment = record.segment();
    spectrum.add(segment);
    measure::Results results;
    spectrum.append_alpha(window, {}, results);
    spectrum.append_series({1, "1", "1"}, results);
    return results;
}

}  // namespace

// Leakage through Bartlett's window and the means of few logarithms: a bias of 0.001 (white noise)
// to 0.01 (alpha = 1.86), whatever the number of samples. The statistical error is held against the
// scatter about the mean of all records.
BOOST_AUTO_TEST_CASE(known_exponents_with_little_bias_within_their_stated_errors) {
    for (const std::size_t samples : {4U, 32U}) {
        for (const double alpha : {0.0, 1.0, 1.33, 1.86}) {
            const int records = samples == 4 ? 200 : 60;
            std::vector<measure::Measurement> all;
            double mean = 0;
            for (int i = 0; i < records; ++i) {
                SyntheticRecord record({16, samples}, 512);
                record.noise(100, alpha, static_cast<std::uint64_t>(i + 1));
                all.push_back(get(spectrum_of(record, {0.01, 0.2}), "alpha"));
                mean += all.back().value / records;
            }
            const auto within = [&](double errors) {
                const auto hits = std::ranges::count_if(all, [&](const auto& m) {
                    return std::abs(m.value - mean) < errors * m.standard_error;
                });
                return static_cast<double>(hits) / records;
            };
            BOOST_TEST_MESSAGE("alpha " << alpha << ", " << samples << " samples: bias "
                                        << mean - alpha << ", within one error " << within(1)
                                        << ", two " << within(2));
            BOOST_TEST(std::abs(mean - alpha) < 0.02);
            // Student's t is within two errors in 0.86 (3 degrees) and 0.95 (31): three standard
            // deviations of the share of so many records below.
            BOOST_TEST(within(2) >= (samples == 4 ? 0.79 : 0.86));
        }
    }
}

BOOST_AUTO_TEST_CASE(the_integral_of_the_spectrum_is_the_variance) {
    SyntheticRecord record({16, 8}, 1024);
    record.noise(20, 0, 5);
    const auto results = spectrum_of(record, {0.01, 0.2});
    double sum = 0;
    for (const double p : column(results, "spectrum", "P"))
        sum += p / 1024;
    BOOST_TEST(std::abs(sum / 400 - 1) < 0.02);
    BOOST_TEST(get(results, "alpha").systematic > 0);
}

BOOST_AUTO_TEST_CASE(a_window_without_three_bins_or_without_power_has_no_exponent) {
    SyntheticRecord record({16, 4}, 64);
    BOOST_TEST(!find(spectrum_of(record, {0.05, 0.4}), "alpha"));
    record.noise(20, 0, 5);
    BOOST_TEST(find(spectrum_of(record, {0.05, 0.4}), "alpha"));
    BOOST_TEST(!find(spectrum_of(record, {0.05, 0.06}), "alpha"));
}
