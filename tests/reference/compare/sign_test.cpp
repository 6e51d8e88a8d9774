// Protects the rule of signs: it says nothing of numbers that may be zero.
#include "reference/compare/sign.hpp"

#include <boost/test/unit_test.hpp>

using namespace crossgrain::compare;

BOOST_AUTO_TEST_CASE(signs_agree_or_not_where_both_are_certain) {
    const Operand up{.value = 1, .standard_error = 0.1, .degrees_of_freedom = 9};
    const Operand down{.value = -1, .standard_error = 0.1, .degrees_of_freedom = 9};
    BOOST_CHECK(judge_sign(up, {.value = 5}).outcome == Outcome::agree);
    BOOST_CHECK(judge_sign(down, down).outcome == Outcome::agree);
    BOOST_CHECK(judge_sign(up, down).outcome == Outcome::disagree);
    BOOST_TEST(judge_sign(up, down).reason == "");
}

BOOST_AUTO_TEST_CASE(an_uncertain_sign_decides_nothing) {
    const Operand exact{.value = 1};
    // t_{0.975} of one degree of freedom is 12.7, of nine 2.26.
    const Operand few{.value = 1, .standard_error = 0.1, .degrees_of_freedom = 1};
    const Operand none{.value = 1, .standard_error = 0.1, .degrees_of_freedom = 0};
    const Operand wide{.value = 1, .standard_error = 0.5, .degrees_of_freedom = 9};
    for (const Operand& unsure : {few, none, wide, Operand{.value = 0}}) {
        BOOST_CHECK(judge_sign(unsure, exact).outcome == Outcome::undecided);
        BOOST_CHECK(judge_sign(exact, unsure).outcome == Outcome::undecided);
        BOOST_TEST(!judge_sign(exact, unsure).reason.empty());
    }
}
