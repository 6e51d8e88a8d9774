// The bit-sliced engine and the table engine are one machine: the same bits, replica by replica,
// for every reading, pipe, width of words and number of replicas.
#include "native/lga/ensemble.hpp"
#include "tests/native/lga/ensembles.hpp"
#include "tests/native/lga/readings.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

using namespace crossgrain;
namespace data = boost::unit_test::data;

namespace {

/// Both advance together; sites and measurements are compared on the way.
void check_agreement(const lga::Model& model, int bits, int blocks = 8, int block = 9) {
    const auto sliced = lga::make_sliced_ensemble(model, bits);
    const auto table = lga::make_table_ensemble(model);
    for (int i = 0; i < blocks; ++i) {
        BOOST_TEST_REQUIRE(tests::first_difference(*sliced, *table, model) == -1,
                           "step " << sliced->step() << ", " << bits << " bits");
        sliced->advance(block);
        table->advance(block);
        BOOST_TEST_REQUIRE(sliced->step() == table->step());
    }
    lga::BinValues a, b;
    const lga::Fields all{.count = true, .rests = true, .momentum = true};
    sliced->measure(5, all, a);
    table->measure(5, all, b);
    BOOST_TEST(a.count == b.count, boost::test_tools::per_element());
    BOOST_TEST(a.rests == b.rests, boost::test_tools::per_element());
    BOOST_TEST(a.momentum == b.momentum, boost::test_tools::per_element());
    BOOST_TEST(sliced->saturated() == table->saturated(), boost::test_tools::per_element());
}

lga::Model open_pipe(const std::string& name, double p) {
    auto model = tests::reading(name, p);
    model.periodic = false;
    model.injection = 0.45;
    model.gravity = 0.3;
    return model;
}

}  // namespace

BOOST_DATA_TEST_CASE(every_reading_in_a_periodic_pipe,
                     data::make(tests::readings) * data::make({0.0, 0.1, 0.8, 1.0}), name, p) {
    auto model = tests::reading(name, p);
    model.replicas = 130;
    model.gravity = 0.3;
    model.roughness = 0.7;
    for (const int bits : lga::word_widths())
        check_agreement(model, bits, 4);
}

BOOST_DATA_TEST_CASE(every_reading_in_an_open_pipe, data::make(tests::readings), name) {
    auto model = open_pipe(name, 0.5);
    model.replicas = 70;
    for (const int bits : lga::word_widths())
        check_agreement(model, bits);
}

BOOST_DATA_TEST_CASE(dense_pipes_with_long_relocations, data::make(tests::readings), name) {
    auto model = tests::reading(name, 0.5);
    model.density = 1.4;
    for (const int bits : lga::word_widths())
        check_agreement(model, bits);
}

BOOST_DATA_TEST_CASE(any_number_of_replicas,
                     data::make({1, 2, 63, 64, 65, 127, 128, 129, 256, 300, 512}), replicas) {
    auto model = tests::reading("P", 0.8);
    model.length = 10;
    model.width = 4;  // an even width: the walls are at different heights
    model.replicas = replicas;
    for (const int bits : lga::word_widths())
        check_agreement(model, bits, 3, 5);
}

BOOST_DATA_TEST_CASE(kicks_and_walls_that_are_certain_or_impossible,
                     data::make({0.0, 1.0}) * data::make({0.0, 1.0}), gravity, roughness) {
    for (const auto& name : tests::readings) {
        auto model = tests::reading(name, 0.25);
        model.gravity = gravity;
        model.roughness = roughness;
        check_agreement(model, lga::best_word_width(model.replicas), 3);
    }
}

BOOST_AUTO_TEST_CASE(a_long_run_at_late_steps) {
    const auto model = tests::reading("P", 0.8);
    check_agreement(model, lga::word_widths().back(), 3, 700);
}

BOOST_AUTO_TEST_CASE(a_replica_is_the_same_alone_and_among_others) {
    auto many = tests::reading("P", 0.8);
    many.replicas = 300;
    auto few = many;
    few.replicas = 3;
    const auto alone = lga::make_table_ensemble(few);
    alone->advance(30);
    for (const int bits : lga::word_widths()) {
        for (const auto& model : {many, few}) {
            const auto sliced = lga::make_sliced_ensemble(model, bits);
            sliced->advance(30);
            BOOST_TEST(tests::first_difference(*sliced, *alone, few) == -1);
        }
    }
}

// The judge is judged: what is compared here must be seen when it is wrong.
BOOST_AUTO_TEST_CASE(a_changed_probability_of_one_row_is_seen) {
    const auto model = tests::reading("P", 0.8);
    auto defect = model;
    defect.rules.front().probability -= 0.02;
    const auto sliced = lga::make_sliced_ensemble(model, 64);
    const auto table = lga::make_table_ensemble(defect);
    sliced->advance(100);
    table->advance(100);
    BOOST_TEST(tests::first_difference(*sliced, *table, model) >= 0);
}

BOOST_AUTO_TEST_CASE(another_seed_is_seen) {
    const auto model = tests::reading("P", 0.8);
    auto other = model;
    other.seed += 1;
    BOOST_TEST(tests::first_difference(*lga::make_sliced_ensemble(model, 64),
                                       *lga::make_table_ensemble(other), model) == 0);
}
