// What the engine refuses at once, and a run that blows up, which ends with a word instead of with
// numbers.
#include "native/base/errors.hpp"
#include "native/friction/simd_step.hpp"
#include "tests/native/friction/systems.hpp"

#include <boost/test/unit_test.hpp>

#include <stdexcept>
#include <string>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

template <class Change>
std::string refusal(Change change) {
    auto p = frictional_discs(0.8, 0.05, 50);
    auto s = colliding_pair(1);
    change(p, s);
    try {
        friction::Engine engine(p, s);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return {};
}

void expect(const std::string& text, const std::string& part) {
    BOOST_TEST(text.find(part) != std::string::npos, "'" << text << "' has no '" << part << "'");
}

}  // namespace

BOOST_AUTO_TEST_CASE(parameters_out_of_range_are_refused) {
    using friction::Parameters;
    using friction::State;
    BOOST_TEST(refusal([](Parameters&, State&) {}) == "");
    expect(refusal([](Parameters& p, State&) { p.dt = 0; }), "dt is 0");
    expect(refusal([](Parameters& p, State&) { p.contact.stiffness = -1; }), "stiffness is -1");
    expect(refusal([](Parameters& p, State&) { p.contact.friction = -0.1; }), "friction");
    expect(refusal([](Parameters& p, State&) { p.contact.tangential_stiffness = 0; }), "spring");
    expect(refusal([](Parameters& p, State&) { p.inertia_factor = 0; }), "inertia");
    expect(refusal([](Parameters& p, State&) { p.period_y = 2; }), "period");
    expect(refusal([](Parameters&, State& s) { s.radius[1] = 0; }), "radius");
    expect(refusal([](Parameters&, State& s) { s.mass[0] = -2; }), "mass");
    expect(refusal([](Parameters&, State& s) { s.omega.pop_back(); }), "length");
    expect(refusal([](Parameters&, State& s) { s.frozen = {2}; }), "frozen");
}

BOOST_AUTO_TEST_CASE(without_a_spring_no_stiffness_is_needed) {
    BOOST_TEST(refusal([](friction::Parameters& p, friction::State&) {
                   p.contact.tangential = friction::TangentialForce::dashpot;
                   p.contact.tangential_stiffness = 0;
               }) == "");
}

BOOST_AUTO_TEST_CASE(a_run_that_blows_up_says_so) {
    for (const auto kernel : {friction::Kernel::scalar, friction::Kernel::simd}) {
        if (kernel == friction::Kernel::simd && friction::simd_lanes() == 0) continue;
        auto p = frictional_discs(0.8, 0.05, 50);
        p.kernel = kernel;
        p.dt = 0.5;  // ten contact times
        p.period_x = p.period_y = 7;
        friction::Engine engine(p, hot_gas(4, 4, 1.5));
        BOOST_CHECK_THROW(engine.advance(100000), TrajectoryError);
    }
}

BOOST_AUTO_TEST_CASE(nothing_and_all_frozen_are_fine) {
    for (const auto kernel : {friction::Kernel::scalar, friction::Kernel::simd}) {
        if (kernel == friction::Kernel::simd && friction::simd_lanes() == 0) continue;
        auto p = frictional_discs(0.8, 0.05, 50);
        p.kernel = kernel;
        BOOST_TEST(after(p, {}, 10).step == 10);
        auto pair = colliding_pair(1);
        pair.frozen = {0, 1};
        const auto end = after(p, pair, 100);
        BOOST_TEST(end.x[0] == pair.x[0]);
        BOOST_TEST(end.vx[0] == 0.0);
    }
}
