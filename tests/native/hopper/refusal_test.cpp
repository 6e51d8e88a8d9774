// Bad input is refused in one clear line that names what is wrong.
#include "native/base/errors.hpp"
#include "tests/native/hopper/hoppers.hpp"

#include <string>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

/// The message with which both engines refuse, or "" if one of them does not.
std::string refusal(const hopper::Parameters& p) {
    std::string text;
    for (const auto kind : {hopper::EngineKind::plain, hopper::EngineKind::fast}) {
        try {
            (void)hopper::make_engine(p, kind);
            return "";
        } catch (const CaseError& error) {
            text = error.what();
        }
    }
    return text;
}

void check_refused(const hopper::Parameters& p, const std::string& key) {
    const auto text = refusal(p);
    BOOST_TEST(text.find(key) != std::string::npos, key << ": " << text);
    BOOST_TEST(text.find('\n') == std::string::npos, text);
}

}  // namespace

BOOST_AUTO_TEST_CASE(good_input_is_not_refused) {
    BOOST_CHECK_NO_THROW(hopper::check(small_hopper()));
    auto p = small_hopper();
    p.rules = {.c_d = 0, .c_o = 0, .c_i = 0, .c_w = 0, .tie_tolerance = 0};
    BOOST_CHECK_NO_THROW(hopper::check(p));  // no energy at all is a model, not a mistake
    p.outlet = 2;
    p.levels = 1;
    p.angle = 179;
    BOOST_CHECK_NO_THROW(hopper::check(p));
}

BOOST_AUTO_TEST_CASE(hoppers_that_cannot_be) {
    auto p = small_hopper();
    for (const int outlet : {1, 0, -3}) {
        p.outlet = outlet;
        check_refused(p, "outlet");
    }
    p = small_hopper();
    p.levels = 0;
    check_refused(p, "levels");
    p = small_hopper();
    for (const double angle : {0.0, -1.0, 180.0, 200.0, std::nan("")}) {
        p.angle = angle;
        check_refused(p, "angle");
    }
    p = small_hopper();
    p.angle = 179.999;
    p.levels = 100'000;
    check_refused(p, "too large a hopper");
    p = small_hopper();
    p.flipped = -1;
    check_refused(p, "flipped");
    p.flipped = 1'000'000;
    check_refused(p, "flipped");
}

BOOST_AUTO_TEST_CASE(coefficients_that_cannot_be) {
    const auto with = [](auto change) {
        auto p = small_hopper();
        change(p.rules);
        return p;
    };
    check_refused(with([](auto& r) { r.c_d = -0.01; }), "c_d");
    check_refused(with([](auto& r) { r.c_o = -1; }), "c_o");
    check_refused(with([](auto& r) { r.c_i = std::nan(""); }), "c_i");
    check_refused(with([](auto& r) { r.c_w = 1e6; }), "c_w");
    check_refused(with([](auto& r) { r.tie_tolerance = -1e-3; }), "tie_tolerance");
    check_refused(with([](auto& r) { r.c_d = 1e-13; }), "c_d");
}

BOOST_AUTO_TEST_CASE(a_tie_tolerance_that_makes_all_candidates_equal) {
    auto p = small_hopper();
    p.rules.tie_tolerance = 100;
    check_refused(p, "tie_tolerance");
    p.rules = {.c_d = 1e-4, .c_o = 1e-4, .c_i = 1e-4, .c_w = 0, .tie_tolerance = 1e-3};
    check_refused(p, "tie_tolerance");
    p.rules.tie_tolerance = 5e-4;
    BOOST_TEST(refusal(p) == "");
}
