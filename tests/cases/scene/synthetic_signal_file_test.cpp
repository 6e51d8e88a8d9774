// A signal with a known answer is exactly what its table says, or it is refused.
#include "tests/cases/scene/gas_text.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace crossgrain;
using tests::check_refusal;

namespace {

CaseErrorDetails signal_refusal(const std::string& what, const std::string& by) {
    return tests::refusal(
        [&] { (void)tests::read_signal(tests::replaced(tests::signal_text, what, by)); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_table_becomes_the_signal) {
    const auto signal = tests::read_signal(tests::signal_text);
    BOOST_TEST(signal.sampling.bins() == 22);
    BOOST_TEST(signal.mean == 1000);
    BOOST_TEST(signal.noise == 50);
    BOOST_TEST(signal.exponent == 1.33);
    BOOST_TEST(signal.wave_amplitude == 20);
    BOOST_TEST(signal.wave_velocity == 0.36);
    BOOST_TEST(signal.wave_number == 1);
    BOOST_TEST(signal.seed == 3U);
    const auto still = tests::read_signal(
        tests::replaced(tests::signal_text, "wave_amplitude = 20\nwave_velocity = 0.36\n", ""));
    BOOST_TEST(still.wave_amplitude == 0);
}

BOOST_AUTO_TEST_CASE(what_is_no_signal_is_refused) {
    check_refusal(signal_refusal("exponent = 1.33", "exponent = 2.5"), "exponent", 5,
                  "is out of range");
    check_refusal(signal_refusal("noise = 50", "noise = 0"), "noise", 4, "is out of range");
    check_refusal(signal_refusal("wave_amplitude = 20", "wave_amplitude = -1"), "wave_amplitude", 6,
                  "is out of range");
    check_refusal(signal_refusal("wave_velocity = 0.36", "wave_velocity = 0.36\nwave_number = 12"),
                  "wave_number", 8, "is out of range");
    check_refusal(signal_refusal("every = 10", "every = 10, fields = [\"rests\"]"), "sample", 8,
                  "asks for fields a signal does not have");
}

BOOST_AUTO_TEST_CASE(counts_that_would_leave_their_range_are_refused) {
    check_refusal(signal_refusal("mean = 1000", "mean = 319"), "mean", 3,
                  "does not keep the counts in range");
    BOOST_CHECK_NO_THROW(
        (void)tests::read_signal(tests::replaced(tests::signal_text, "mean = 1000", "mean = 320")));
    check_refusal(signal_refusal("mean = 1000", "mean = 65500"), "mean", 3,
                  "does not keep the counts in range");
}
