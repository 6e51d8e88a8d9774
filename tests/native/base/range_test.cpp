// An interval holds its ends only where they are closed, and nothing that is not finite.
#include "native/base/range.hpp"

#include <boost/test/unit_test.hpp>

#include <limits>

using crossgrain::Range;

BOOST_AUTO_TEST_CASE(an_open_end_does_not_belong_to_the_interval) {
    for (const double low : {0.0, 1.0}) {
        BOOST_TEST(!Range::open(0, 1).holds(low));
        BOOST_TEST(Range::left_open(0, 1).holds(low) == (low == 1));
        BOOST_TEST(Range::right_open(0, 1).holds(low) == (low == 0));
    }
    BOOST_TEST(Range::open(0, 1).holds(0.5));
    BOOST_TEST(!Range::positive().holds(0));
    BOOST_TEST(Range::not_negative().holds(0));
    BOOST_TEST(!Range::at_least(2).holds(1.9));
    BOOST_TEST(Range::whole(1, 3).holds(3));
    BOOST_TEST(!Range::whole(1, 3).holds(4));
}

BOOST_AUTO_TEST_CASE(what_is_not_finite_is_in_no_interval) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
        BOOST_TEST(!Range::any().holds(value));
        BOOST_TEST(!Range::not_negative().holds(value));
    }
}

BOOST_AUTO_TEST_CASE(the_text_says_which_ends_belong) {
    BOOST_TEST(Range::open(0, 1).text == "a number in (0, 1)");
    BOOST_TEST(Range::right_open(0, 360).text == "a number in [0, 360)");
    BOOST_TEST(Range::whole(1, 64).text == "an integer from 1 to 64");
}
