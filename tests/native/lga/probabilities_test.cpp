// Each chance of the model happens as often as it says, also where it is no short binary fraction.
#include "tests/native/lga/ensembles.hpp"
#include "tests/native/lga/readings.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>

using namespace crossgrain;
namespace data = boost::unit_test::data;

namespace {

/// No collisions, no kicks, specular walls.
lga::Model idle(double density) {
    auto model = tests::reading("P", 0);
    model.rules.clear();
    model.gravity = 0;
    model.roughness = 0;
    model.length = 200;
    model.width = 20;
    model.density = density;
    model.replicas = 512;
    return model;
}

std::int64_t momentum(const lga::Ensemble& gas, const lga::Model& model) {
    lga::BinValues values;
    gas.measure(model.length, {.count = false, .rests = false, .momentum = true}, values);
    std::int64_t sum = 0;
    for (const auto n : values.momentum)
        sum += n;
    return sum;
}

std::int64_t at_rest(const lga::Ensemble& gas, const lga::Model& model) {
    lga::BinValues values;
    gas.measure(model.length, {.count = false, .rests = true, .momentum = false}, values);
    std::int64_t sum = 0;
    for (const auto n : values.rests)
        sum += n;
    return sum;
}

/// Five standard deviations of a binomial fraction; the seed is fixed.
double allowed(double p, std::int64_t n) {
    return 5 * std::sqrt(p * (1 - p) / static_cast<double>(n)) + 0x1p-25;
}

}  // namespace

// One row, met at every site: 0 and 3 stop with probability q.
BOOST_DATA_TEST_CASE(a_row_happens_with_its_probability, data::make({0.8, 0.1, 1.0 / 3, 0.7321}),
                     q) {
    auto model = idle(0);
    model.rules.push_back({{0b111111, 0}, {0b111111, 0}, 1 - q});
    model.rules.push_back({{0b111111, 0}, {0b110110, 2}, q});
    // 6 W + 4 moving states per row with walls outside: all filled.
    model.density = (6.0 * model.width + 4) / model.width;
    model.relocation = lga::Relocation::random_walk;
    const auto gas = lga::make_sliced_ensemble(model, lga::best_word_width(512));
    gas->advance(1);
    const std::int64_t sites = std::int64_t{model.length} * model.width * 512;
    // Two rests a time; more than fit at q > 1/2, but all are counted.
    const double fraction =
        static_cast<double>(at_rest(*gas, model)) / 2.0 / static_cast<double>(sites);
    BOOST_TEST(std::abs(fraction - q) < allowed(q, sites), fraction << " instead of " << q);
}

// A kick turns 2 into 1 or 4 into 5: two units of downward momentum, by which kicks are counted.
BOOST_DATA_TEST_CASE(a_kick_happens_with_probability_g, data::make({0.2, 0.5, 0.25, 0.9137}), g) {
    auto model = idle(1.0);
    model.gravity = g;
    model.gravity_rule = {
        .rest_to_down = false, .up_diagonals = true, .up_to_rest = false, .on_walls = false};
    const auto gas = lga::make_sliced_ensemble(model, lga::best_word_width(512));
    const lga::Geometry geometry(model);
    std::int64_t candidates = 0;
    for (int r = 0; r < model.replicas; ++r) {
        const auto sites = tests::sites(*gas, model, r);
        for (int i = geometry.rows(); i < geometry.sites() - geometry.rows(); ++i) {
            const unsigned site = sites[static_cast<std::size_t>(i)];
            candidates += (site >> 2 & 1U) & ~(site >> 1 & 1U);
            candidates += (site >> 4 & 1U) & ~(site >> 5 & 1U);
        }
    }
    const auto before = momentum(*gas, model);
    gas->advance(1);
    const double fraction =
        static_cast<double>(momentum(*gas, model) - before) / 2.0 / static_cast<double>(candidates);
    BOOST_TEST(std::abs(fraction - g) < allowed(g, candidates), fraction << " instead of " << g);
}

BOOST_DATA_TEST_CASE(a_state_is_filled_with_probability_i, data::make({0.52, 0.1, 0.3333}), i) {
    auto model = idle(0);
    model.periodic = false;
    model.injection = i;
    model.length = 10;
    model.width = 2000;
    const auto gas = lga::make_sliced_ensemble(model, lga::best_word_width(512));
    gas->advance(1);
    lga::BinValues values;
    gas->measure(model.length, {}, values);
    std::int64_t count = 0;
    for (const auto n : values.count)
        count += n;
    // 1 per interior column, 2 more in every other one, 1 at either wall.
    const std::int64_t slots = std::int64_t{512} * (model.width + model.width + 2);
    const double fraction = static_cast<double>(count) / static_cast<double>(slots);
    BOOST_TEST(std::abs(fraction - i) < allowed(i, slots), fraction << " instead of " << i);
}
