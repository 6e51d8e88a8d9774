// Rest particles that find no place end the run, in both engines in the same replicas and at the
// same step, and a pipe that can hold them goes on.
#include "tests/native/lga/ensembles.hpp"
#include "tests/native/lga/readings.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>
#include <string>

using namespace crossgrain;
namespace data = boost::unit_test::data;

namespace {

/// Nothing falls, and all that collides stops: rests only accumulate.
lga::Model jammed(const std::string& name, double density) {
    auto model = tests::reading(name, 1);
    model.length = 10;
    model.gravity = 0;
    model.density = density;
    model.replicas = 100;
    return model;
}

}  // namespace

BOOST_DATA_TEST_CASE(more_rests_than_sites_end_the_run, data::make(tests::readings), name) {
    const auto model = jammed(name, 2.5);
    const auto table = lga::make_table_ensemble(model);
    table->advance(100'000);
    BOOST_TEST_REQUIRE(!table->saturated().empty());
    for (const int bits : lga::word_widths()) {
        const auto sliced = lga::make_sliced_ensemble(model, bits);
        sliced->advance(100'000);
        BOOST_TEST(sliced->step() == table->step());
        BOOST_TEST(sliced->saturated() == table->saturated(), boost::test_tools::per_element());
        BOOST_TEST(tests::first_difference(*sliced, *table, model) == -1);
        lga::BinValues a, b;
        sliced->measure(5, {.count = true, .rests = true, .momentum = true}, a);
        table->measure(5, {.count = true, .rests = true, .momentum = true}, b);
        BOOST_TEST(a.count == b.count, boost::test_tools::per_element());
        BOOST_TEST(a.rests == b.rests, boost::test_tools::per_element());
    }
}

BOOST_AUTO_TEST_CASE(no_particle_is_lost_in_a_saturated_replica) {
    const auto model = jammed("P", 2.5);
    const auto gas = lga::make_sliced_ensemble(model, lga::best_word_width(model.replicas));
    gas->advance(100'000);
    lga::BinValues values;
    gas->measure(model.length, {.count = true, .rests = true, .momentum = false}, values);
    const lga::Geometry geometry(model);
    for (std::size_t r = 0; r < values.count.size(); ++r) {
        BOOST_TEST(values.count[r] == 175);
        if (gas->saturated()[r]) BOOST_TEST(values.rests[r] > geometry.interior_sites());
    }
}

BOOST_AUTO_TEST_CASE(a_saturated_ensemble_stays_where_it_is) {
    const auto model = jammed("P", 2.5);
    const auto gas = lga::make_sliced_ensemble(model, 64);
    gas->advance(100'000);
    const auto step = gas->step();
    gas->advance(10);
    BOOST_TEST(gas->step() == step);
}

BOOST_AUTO_TEST_CASE(a_pipe_that_can_hold_all_rests_never_saturates) {
    const auto model = jammed("P", 0.9);
    const auto gas = lga::make_sliced_ensemble(model, lga::best_word_width(model.replicas));
    gas->advance(2000);
    BOOST_TEST(gas->saturated().empty());
    BOOST_TEST(gas->step() == 2000);
}
