// Hints: a typing error finds its word, anything else finds none.
#include "cases/toml/toml_table.hpp"

#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

using crossgrain::toml_input::nearest;

namespace {

const std::vector<std::string> keys{"restitution", "contact_time", "stiffness", "damping",
                                    "damping_coefficient"};

std::string hint(std::string_view word) {
    return nearest(word, keys).value_or("none");
}

}  // namespace

BOOST_AUTO_TEST_CASE(one_or_two_wrong_letters_find_the_word) {
    BOOST_TEST(hint("restitution") == "restitution");
    BOOST_TEST(hint("restituton") == "restitution");    // one is missing
    BOOST_TEST(hint("restittution") == "restitution");  // one is too many
    BOOST_TEST(hint("restotution") == "restitution");   // one is wrong
    BOOST_TEST(hint("erstitution") == "restitution");   // two are exchanged
    BOOST_TEST(hint("dampnig") == "damping");
    BOOST_TEST(hint("stifness") == "stiffness");
}

BOOST_AUTO_TEST_CASE(longer_words_may_have_more_errors) {
    BOOST_TEST(hint("damping-coeficent") == "damping_coefficient");
    BOOST_TEST(hint("contacttimes") == "contact_time");
}

BOOST_AUTO_TEST_CASE(the_nearest_of_several_wins) {
    BOOST_TEST(hint("damping_coefficien") == "damping_coefficient");
    BOOST_TEST(hint("damping_") == "damping");
}

BOOST_AUTO_TEST_CASE(another_word_finds_nothing) {
    BOOST_TEST(hint("viscosity") == "none");
    BOOST_TEST(hint("") == "none");
    BOOST_TEST(hint("x") == "none");
    BOOST_TEST(!nearest("restitution", {}).has_value());
}
