// A name in a case file cannot choose where a file goes.
#include "native/base/file_stem.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using crossgrain::file_stem;
using namespace std::string_literals;

BOOST_AUTO_TEST_CASE(parts_are_joined_and_stay_readable) {
    BOOST_TEST(file_stem({"bed-fluid", "", "lammps", "e=0.8"}) == "bed-fluid-lammps-e=0.8");
}

BOOST_AUTO_TEST_CASE(nothing_leaves_the_directory) {
    BOOST_TEST(file_stem({"../../etc"}) == "_.._.._etc");
    BOOST_TEST(file_stem({".."}) == "_..");
    BOOST_TEST(file_stem({""}) == "_");
    BOOST_TEST(file_stem({"a\0b\n$(x)"s}) == "a_b___x_");
    BOOST_TEST(file_stem({"-rf"}) == "_-rf");
    BOOST_TEST(file_stem({std::string(5000, 'x')}).size() == 160u);
}
