// The space-time picture: orientation, shades, and how many rows.
#include "cases/measure/gas/gas_picture.hpp"
#include "tests/cases/measure/synthetic_gas.hpp"

#include <boost/test/unit_test.hpp>

using namespace crossgrain;
using namespace crossgrain::tests;

namespace {

scene::GasSampling sampling(std::int64_t steps = 20) {
    return {.length = 40, .width = 11, .bin = 10, .replicas = 3, .steps = steps, .every = 10};
}

}  // namespace

BOOST_AUTO_TEST_CASE(time_runs_upwards_and_dense_is_dark) {
    measure::GasPicture picture(sampling(), {.replica = 1});
    // In replica 1: 10 particles everywhere, 20 in bin 3 of the last frame.
    const auto results = run_gas(sampling(), picture, [](SyntheticGas& gas) {
        gas.fill([&](std::size_t i, std::size_t r) {
            return r != 1 ? 99.0 : gas.step == 20 && i == 3 ? 20.0 : 10.0;
        });
    });
    const auto& shown = results.pictures.at(0);
    BOOST_TEST(shown.width == 4U);
    BOOST_TEST(shown.height == 3U);
    BOOST_TEST(shown.pixels.size() == 12U);
    BOOST_TEST(shown.pixels[3] == 255);  // top row: the last instant
    BOOST_TEST(shown.pixels[4 + 3] == 0);
    BOOST_TEST(shown.palette.at(255)[0] == 0);  // black
    BOOST_TEST(shown.palette.at(0)[0] == 255);  // white
    BOOST_TEST(shown.title.find("white 10, black 20") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(long_runs_are_thinned) {
    const auto gas = sampling(100'000);  // 10001 frames
    measure::GasPicture picture(gas, {.rows = 100});
    const auto results = run_gas(gas, picture, [](SyntheticGas& one) {
        one.fill([](std::size_t, std::size_t) { return 7.0; });  // no contrast at all
    });
    BOOST_TEST(results.pictures.at(0).height <= 100U);
    BOOST_TEST(results.pictures.at(0).height > 50U);
}

BOOST_AUTO_TEST_CASE(options_out_of_range_are_refused) {
    BOOST_CHECK_THROW((measure::GasPicture{sampling(), {.replica = 3}}), std::invalid_argument);
    BOOST_CHECK_THROW((measure::GasPicture{sampling(), {.rows = 0}}), std::invalid_argument);
}
