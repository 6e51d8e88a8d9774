// The median is a value of the sample, whatever the order.
#include "native/numerics/median.hpp"

#include <boost/test/unit_test.hpp>

#include <stdexcept>

using crossgrain::numerics::median;

BOOST_AUTO_TEST_CASE(middle_of_an_odd_number_and_upper_middle_of_an_even_one) {
    BOOST_TEST(median({5, 1, 3}) == 3);
    BOOST_TEST(median({4, 1, 3, 2}) == 3);
    BOOST_TEST(median({7}) == 7);
    BOOST_TEST(median({1, 1, 1e300, 1, 2}) == 1);
}

BOOST_AUTO_TEST_CASE(nothing_has_no_median) {
    BOOST_CHECK_THROW((void)median({}), std::invalid_argument);
}
