// What YADE prints when something goes wrong, as it was seen, and what is made of it.
#include "adapters/yade/yade_errors.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

using crossgrain::adapters::yade::first_error;
using crossgrain::adapters::yade::without_colours;

namespace {

const std::string start = "Running script scene.py\n";
const std::string traceback = "Traceback (most recent call last):\n"
                              "  File \"/usr/bin/yade\", line 343, in runScript\n"
                              "    execfile(script,globals())\n"
                              "NameError: name 'x' is not defined\n";

}  // namespace

BOOST_AUTO_TEST_CASE(a_good_run_has_no_error) {
    BOOST_TEST(!first_error(start));
    BOOST_TEST(!first_error(""));
    BOOST_TEST(!first_error(start + "<WARNING> InsertionSortCollider: verletDist is set to 0\n"));
}

BOOST_AUTO_TEST_CASE(a_traceback_is_told_by_its_last_line) {
    BOOST_TEST(first_error(start + traceback).value() == "NameError: name 'x' is not defined");
}

BOOST_AUTO_TEST_CASE(a_traceback_that_is_cut_off_is_still_an_error) {
    BOOST_TEST(first_error("Traceback (most recent call last):").has_value());
    BOOST_TEST(first_error("Traceback (most recent call last):\n").has_value());
    BOOST_TEST(first_error("Traceback (most recent call last):\n  File \"a").has_value());
}

BOOST_AUTO_TEST_CASE(the_scripts_own_message_comes_first) {
    BOOST_TEST(first_error(start + traceback + "ERROR: dt is too large\n").value() ==
               "ERROR: dt is too large");
}

BOOST_AUTO_TEST_CASE(yades_log_says_more_than_the_traceback_after_it) {
    const std::string log = "<\x1b[91m"
                            "FATAL ERROR\x1b[0m> \x1b[93mInsertionSortCollider\x1b[0m: Body #1 "
                            "spans over half of the cell size 4.05\n";
    BOOST_TEST(first_error(start + log + traceback).value() ==
               "<FATAL ERROR> InsertionSortCollider: Body #1 spans over half of the cell size "
               "4.05");
}

BOOST_AUTO_TEST_CASE(an_uncaught_exception_is_told_by_its_text) {
    BOOST_TEST(first_error(start + "terminate called after throwing an instance of "
                                   "'std::runtime_error'\n  what():  k1 have to be less as kp!\n")
                   .value() == "what():  k1 have to be less as kp!");
}

BOOST_AUTO_TEST_CASE(colours_are_removed) {
    BOOST_TEST(without_colours("a\x1b[0;31mb\x1b[0mc") == "abc");
    BOOST_TEST(without_colours("a\x1b[") == "a");
    BOOST_TEST(without_colours("") == "");
}
