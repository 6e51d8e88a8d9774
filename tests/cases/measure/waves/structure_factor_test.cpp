// S(k) of noise is flat and has no strongest wave; a wave is found at its k, an exponent within its
// stated error.
#include "cases/measure/waves/structure_factor.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"
#include "tests/cases/measure/synthetic_record.hpp"

#include <boost/test/unit_test.hpp>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

measure::Results structure_of(const SyntheticRecord& record) {
    measure::StructureFactor factor(record.description().shape, {1, 7});
    for (std::size_t t = 0; t < record.points(); ++t)
        factor.add(record.field(t));
    measure::Results results;
    factor.append(results);
    return results;
}

}  // namespace

BOOST_AUTO_TEST_CASE(noise_has_no_wave_number_in_a_thousand_records) {
    int found = 0, within_two = 0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        SyntheticRecord record({32, 8}, 16);
        record.noise(30, 0, seed);
        const auto results = structure_of(record);
        found += find(results, "wave_number") ? 1 : 0;
        const auto exponent = get(results, "wave_number_exponent");
        within_two += std::abs(exponent.value) < 2 * exponent.standard_error ? 1 : 0;
    }
    BOOST_TEST_MESSAGE("noise: " << found
                                 << " wave numbers in 1000 records, exponent 0 within two "
                                    "errors in "
                                 << within_two);
    BOOST_TEST(found <= 3);
    BOOST_TEST(within_two >= 850);  // Student's t of 7 degrees: 914
}

BOOST_AUTO_TEST_CASE(a_wave_is_found_at_its_wave_number) {
    SyntheticRecord record({32, 8}, 64);
    record.noise(30, 0, 3).wave(30, 0.4, 3);
    const auto results = structure_of(record);
    BOOST_TEST(get(results, "wave_number").value == 3.0);
    // |n_3|^2 = (K a/2)^2 above the noise K 30^2, over K 1000.
    BOOST_TEST(std::abs(column(results, "wave-numbers", "S")[2] - (0.9 + 32 * 225 / 1000.0)) < 0.6);
}

BOOST_AUTO_TEST_CASE(too_few_samples_or_bins_and_windows_out_of_range_are_refused) {
    const auto make = [](measure::FieldShape shape, measure::WaveNumbers window) {
        measure::StructureFactor factor(shape, window);
    };
    BOOST_CHECK_THROW(make({32, 2}, {1, 7}), std::invalid_argument);
    BOOST_CHECK_THROW(make({15, 8}, {1, 7}), std::invalid_argument);
    BOOST_CHECK_THROW(make({32, 8}, {0, 7}), std::invalid_argument);
    BOOST_CHECK_THROW(make({32, 8}, {7, 7}), std::invalid_argument);
    BOOST_CHECK_THROW(make({32, 8}, {1, 17}), std::invalid_argument);
}
