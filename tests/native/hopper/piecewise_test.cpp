// Energies only decide by their order, so trajectories are piecewise constant in the coefficients:
// bit-identical between thresholds, different beyond them.
#include "tests/native/hopper/hoppers.hpp"

using namespace crossgrain;
using namespace crossgrain::tests;
using hopper::EngineKind;

namespace {

std::vector<std::uint8_t> end_at(double c_d, double c_o = 0) {
    auto p = small_hopper();
    p.outlet = 20;
    p.levels = 200;
    p.rules.c_d = c_d;
    p.rules.c_o = c_o;
    const auto engine = hopper::make_engine(p, EngineKind::fast);
    engine->advance(100);
    return engine->state();
}

}  // namespace

BOOST_AUTO_TEST_CASE(trajectories_are_bit_identical_between_thresholds_of_c_d) {
    BOOST_TEST((end_at(0.01) == end_at(0.03)));
    BOOST_TEST((end_at(0.09) == end_at(0.095)));
    BOOST_TEST((end_at(0.09) == end_at(0.098)));
    BOOST_TEST((end_at(0.3) == end_at(0.5)));
    BOOST_TEST((end_at(0.3) == end_at(1)));
}

BOOST_AUTO_TEST_CASE(and_differ_from_piece_to_piece) {
    BOOST_TEST((end_at(0) != end_at(0.01)));
    BOOST_TEST((end_at(0.03) != end_at(0.09)));
    BOOST_TEST((end_at(0.098) != end_at(0.1)));
    BOOST_TEST((end_at(0.1) != end_at(0.11)));
    BOOST_TEST((end_at(0.11) != end_at(0.3)));
}

BOOST_AUTO_TEST_CASE(thresholds_of_c_o_come_from_the_tie_tolerance) {
    // C_O counts 0, 1 or 2 times: 2 C_O and C_O pass eps = 0.001 at 0.0005 and 0.001; at both the
    // energies are equal to the last unit and still a tie.
    BOOST_TEST((end_at(0.5, 0) == end_at(0.5, 0.0005)));
    BOOST_TEST((end_at(0.5, 0.0005) != end_at(0.5, 0.0009)));
    BOOST_TEST((end_at(0.5, 0.0009) == end_at(0.5, 0.001)));
    BOOST_TEST((end_at(0.5, 0.001) != end_at(0.5, 0.0011)));
    BOOST_TEST((end_at(0.5, 0.0011) == end_at(0.5, 0.002)));
}
