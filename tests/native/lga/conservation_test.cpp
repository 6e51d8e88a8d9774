// What the gas must keep: particles, and without dissipation and walls' roughness the known
// motions.
#include "native/lga/initial_state.hpp"
#include "tests/native/lga/ensembles.hpp"
#include "tests/native/lga/readings.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <bit>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

using namespace crossgrain;
namespace data = boost::unit_test::data;

namespace {

int particles(const lga::Ensemble& gas, const lga::Model& model, int replica) {
    int n = 0;
    for (const auto site : tests::sites(gas, model, replica))
        n += std::popcount(site);
    return n;
}

std::unique_ptr<lga::Ensemble> widest(const lga::Model& model) {
    return lga::make_sliced_ensemble(model, lga::best_word_width(model.replicas));
}

lga::BinValues measured(const lga::Ensemble& gas, int bin) {
    lga::BinValues values;
    gas.measure(bin, {.count = true, .rests = true, .momentum = true}, values);
    return values;
}

}  // namespace

BOOST_DATA_TEST_CASE(a_periodic_pipe_keeps_its_particles_in_every_replica,
                     data::make(tests::readings) * data::make({0.7, 1.0, 1.3}), name, density) {
    auto model = tests::reading(name, 0.5);
    model.density = density;
    const auto gas = widest(model);
    const auto expected = lga::particles(model);
    for (int block = 0; block < 3; ++block) {
        for (int r = 0; r < model.replicas; ++r) {
            BOOST_TEST_REQUIRE(particles(*gas, model, r) == expected);
        }
        gas->advance(40);
    }
}

BOOST_AUTO_TEST_CASE(the_number_of_particles_is_exact_and_all_start_moving) {
    auto model = tests::reading("P", 0.5);
    model.density = 1.003;  // 140.42 particles
    BOOST_TEST(lga::particles(model) == 140);
    for (const auto site : lga::initial_state(model, 3))
        BOOST_TEST((site >> lga::rest_bit) == 0);
}

BOOST_AUTO_TEST_CASE(what_the_moving_states_cannot_hold_starts_at_rest) {
    auto model = tests::reading("P", 0);
    model.density = 6.8;
    BOOST_TEST(particles(*widest(model), model, 0) == lga::particles(model));
}

BOOST_AUTO_TEST_CASE(measurements_count_what_is_there) {
    auto model = tests::reading("P", 0.5);
    const auto gas = widest(model);
    gas->advance(37);
    const auto values = measured(*gas, 4);
    const lga::Geometry geometry(model);
    for (int r = 0; r < model.replicas; r += 7) {
        const auto sites = tests::sites(*gas, model, r);
        for (int bin = 0; bin < model.length / 4; ++bin) {
            int count = 0, rests = 0, momentum = 0;
            for (int i = 0; i < geometry.sites(); ++i) {
                if (i % geometry.rows() / 4 != bin) continue;
                const auto site = sites[static_cast<std::size_t>(i)];
                count += std::popcount(site);
                rests += site >> lga::rest_bit;
                momentum += lga::momentum(site & 63U).down;
            }
            const auto at = static_cast<std::size_t>(bin * model.replicas + r);
            BOOST_TEST(values.count[at] == count);
            BOOST_TEST(values.rests[at] == rests);
            BOOST_TEST(values.momentum[at] == momentum);
        }
    }
}

// Collisions and specular walls keep the momentum along the pipe; without gravity nothing adds any.
BOOST_AUTO_TEST_CASE(smooth_walls_and_no_gravity_keep_the_momentum_along_the_pipe) {
    for (const auto& name : tests::readings) {
        auto model = tests::reading(name, 0.5);
        model.gravity = 0;
        model.roughness = 0;
        const auto gas = widest(model);
        const auto before = measured(*gas, model.length).momentum;
        gas->advance(60);
        BOOST_TEST(measured(*gas, model.length).momentum == before,
                   boost::test_tools::per_element());
    }
}

// With roughness the walls take momentum out: the check above must see it.
BOOST_AUTO_TEST_CASE(rough_walls_change_the_momentum_along_the_pipe) {
    auto model = tests::reading("P", 0.5);
    model.gravity = 0;
    const auto gas = widest(model);
    const auto before = measured(*gas, model.length).momentum;
    gas->advance(60);
    BOOST_TEST((measured(*gas, model.length).momentum != before));
}

// Without collisions and gravity all paths are closed.
BOOST_AUTO_TEST_CASE(free_particles_come_round) {
    auto model = tests::reading("P", 0);
    model.rules.clear();
    model.gravity = 0;
    model.roughness = 1;  // bounced back: diagonal paths are walked to and fro
    model.density = 0.2;
    const auto gas = widest(model);
    std::vector<std::vector<std::uint8_t>> before;
    for (int r = 0; r < model.replicas; ++r)
        before.push_back(tests::sites(*gas, model, r));
    // Vertical movers need L steps; diagonal ones come back after twice the way between the walls.
    const lga::Geometry geometry(model);
    const int period = std::lcm(model.length, 2 * (geometry.columns() - 1));
    gas->advance(period);
    for (int r = 0; r < model.replicas; ++r) {
        BOOST_TEST_REQUIRE((tests::sites(*gas, model, r) == before[static_cast<std::size_t>(r)]));
    }
}

BOOST_AUTO_TEST_CASE(an_open_pipe_starts_empty_is_fed_and_drains) {
    auto model = tests::reading("P", 0.5);
    model.periodic = false;
    model.injection = 0.4;
    const auto gas = widest(model);
    BOOST_TEST(particles(*gas, model, 0) == 0);
    gas->advance(100);
    BOOST_TEST(particles(*gas, model, 0) > 0);
    model.injection = 0;
    const auto unfed = widest(model);
    unfed->advance(50);
    for (int r = 0; r < model.replicas; ++r)
        BOOST_TEST(particles(*unfed, model, r) == 0);
}

// Certain injection fills one state in every interior column, two more in those
// that are half a site higher, and one at either wall.
BOOST_AUTO_TEST_CASE(injection_feeds_the_states_that_come_from_outside) {
    auto model = tests::reading("P", 0);
    model.rules.clear();
    model.gravity = 0;
    model.periodic = false;
    model.injection = 1;
    const auto gas = widest(model);
    gas->advance(1);
    for (int r = 0; r < model.replicas; ++r) {
        BOOST_TEST(particles(*gas, model, r) == 7 + 2 * 4 + 2);
    }
}

// A state that a reflection has taken is not filled: two less, where walls are smooth.
BOOST_AUTO_TEST_CASE(injection_leaves_taken_states_alone) {
    auto model = tests::reading("P", 0);
    model.rules.clear();
    model.gravity = 0;
    model.roughness = 0;
    model.periodic = false;
    model.injection = 1;
    const auto gas = widest(model);
    gas->advance(2);
    BOOST_TEST(particles(*gas, model, 0) == 2 * (7 + 2 * 4 + 2) - 2);
}
