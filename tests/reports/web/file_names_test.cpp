// Names from a document become file names that are safe and never alike.
#include <boost/test/unit_test.hpp>

#include "reports/web/file_names.hpp"

using crossgrain::reports::FileNames;

BOOST_AUTO_TEST_CASE(parts_are_joined_and_cleaned) {
    FileNames names;
    BOOST_TEST(names.next({"pipe-gas-fig2", "native-lga", "P/b=0.5", "space-time"}, ".png") ==
               "pipe-gas-fig2-native-lga-P_b=0.5-space-time.png");
    BOOST_TEST(names.next({"a", "", "b"}, ".png") == "a-b.png");
    BOOST_TEST(names.next({"../../x", "%2e#?&<\"'\\ \xC3\xA4"}, ".js") ==
               "_.._.._x-_2e__________.js");
    BOOST_TEST(names.next({}, ".js") == "_.js");
}

BOOST_AUTO_TEST_CASE(names_are_never_alike) {
    FileNames names;
    BOOST_TEST(names.next({"a", "b/c"}, ".png") == "a-b_c.png");
    BOOST_TEST(names.next({"a", "b/c"}, ".png") == "a-b_c-2.png");
    BOOST_TEST(names.next({"a-b", "c"}, ".png") == "a-b-c.png");
    BOOST_TEST(names.next({"a", "b", "c"}, ".png") == "a-b-c-2.png");
    BOOST_TEST(names.next({"A-B", "C"}, ".png") == "A-B-C-3.png");  // file systems may ignore case
    BOOST_TEST(names.next({"a", "b_c-2"}, ".png") == "a-b_c-2-2.png");
    const std::string longest(1000, 'x');
    BOOST_TEST(names.next({longest, "1"}, ".png").size() < 200);
    BOOST_TEST(names.next({longest, "1"}, ".png") != names.next({longest, "2"}, ".png"));
}
