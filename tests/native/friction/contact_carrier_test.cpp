// Springs are found again from either side, and nothing is found that was not kept.
#include "native/friction/contact_carrier.hpp"

#include <boost/test/unit_test.hpp>

using namespace crossgrain::friction;

BOOST_AUTO_TEST_CASE(a_spring_is_found_from_either_side) {
    ContactCarrier carrier(5);
    carrier.keep(3, 1, {.x = 0.5, .y = -0.25, .nx = 0.6, .ny = 0.8});
    carrier.keep(1, 4, {.x = 2, .y = 3, .nx = 1, .ny = 0});
    const auto same = carrier.find(3, 1), other = carrier.find(1, 3);
    BOOST_TEST(same.x == 0.5);
    BOOST_TEST(same.ny == 0.8);
    BOOST_TEST(other.x == -0.5);
    BOOST_TEST(other.y == 0.25);
    BOOST_TEST(other.nx == -0.6);
    BOOST_TEST(carrier.find(4, 1).y == -3.0);
}

BOOST_AUTO_TEST_CASE(what_was_not_kept_is_relaxed) {
    ContactCarrier carrier(5);
    carrier.keep(0, 1, {.x = 1, .y = 1, .nx = 1, .ny = 0});
    BOOST_TEST(carrier.find(0, 2).x == 0.0);
    BOOST_TEST(carrier.find(1, 2).nx == 0.0);
    carrier.clear();
    BOOST_TEST(carrier.find(0, 1).x == 0.0);
}
