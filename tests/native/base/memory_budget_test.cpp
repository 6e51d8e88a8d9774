// The budget of a run is finite, and what does not fit is refused with both numbers.
#include "native/base/memory_budget.hpp"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <stdexcept>
#include <string>

using namespace crossgrain;

BOOST_AUTO_TEST_CASE(the_budget_is_what_there_is_but_no_more_than_eight_gibibytes) {
    BOOST_TEST(memory_budget() > 0x1p26);
    BOOST_TEST(memory_budget() <= 8 * 0x1p30);
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_refused) {
    BOOST_CHECK_NO_THROW(require_memory(0, "nothings"));
    BOOST_CHECK_NO_THROW(require_memory(memory_budget(), "all that there is"));
    BOOST_CHECK_EXCEPTION(
        require_memory(0x1p60, "dreams"), std::invalid_argument, [](const auto& error) {
            return std::string(error.what()).starts_with("dreams need 1.05e+06 TiB, of at most ");
        });
    for (const double odd :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        BOOST_CHECK_THROW(require_memory(odd, "dreams"), std::invalid_argument);
    }
}

BOOST_AUTO_TEST_CASE(bytes_are_shown_in_the_largest_unit_that_fits) {
    BOOST_TEST(shown_bytes(0) == "0 bytes");
    BOOST_TEST(shown_bytes(1023) == "1.02e+03 bytes");
    BOOST_TEST(shown_bytes(1024) == "1 KiB");
    BOOST_TEST(shown_bytes(8 * 0x1p30) == "8 GiB");
    BOOST_TEST(shown_bytes(46.1 * 0x1p30) == "46.1 GiB");
}
