// Rules as data: what a table may say, and what the compiled trees make of it.
#include "native/base/errors.hpp"
#include "native/lga/collision_table.hpp"
#include "tests/native/lga/readings.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

using namespace crossgrain;
namespace data = boost::unit_test::data;

namespace {

/// Probabilities of the outcomes (movers, rests, origins) of a packed site.
using Distribution = std::map<std::array<int, 3>, double>;

void collect(const lga::CollisionTable& table, const lga::Branch& branch, double probability,
             Distribution& all) {
    if (branch.is_outcome) {
        const auto& o = table.outcomes[static_cast<std::size_t>(branch.index)];
        all[{o.movers, o.rests, o.origins}] += probability;
        return;
    }
    const auto& d = table.decisions[static_cast<std::size_t>(branch.index)];
    const double yes = d.below / static_cast<double>(lga::certain);
    collect(table, d.yes, probability * yes, all);
    collect(table, d.no, probability * (1 - yes), all);
}

Distribution outcomes(const lga::Model& model, const lga::SiteState& site) {
    const auto table = lga::compile(model);
    Distribution all;
    const unsigned packed = site.movers | static_cast<unsigned>(site.rests) << lga::rest_bit;
    collect(table, table.roots[packed], 1, all);
    return all;
}

/// A probability is honoured to 2^-24, and products of a few of them hardly worse.
constexpr double resolution = 1e-6;

void check(const Distribution& actual, const Distribution& expected) {
    BOOST_TEST(actual.size() == expected.size());
    for (const auto& [outcome, probability] : expected) {
        const auto found = actual.find(outcome);
        BOOST_TEST_REQUIRE((found != actual.end()));
        BOOST_TEST(std::abs(found->second - probability) < resolution,
                   found->second << " instead of " << probability);
    }
}

std::string refusal(lga::Rule rule) {
    auto model = tests::reading("P", 0.5);
    rule.origin = "mine.toml:3";
    model.rules.push_back(rule);
    try {
        (void)lga::compile(model);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_DATA_TEST_CASE(every_outcome_of_every_reading_conserves_mass_and_momentum,
                     data::make(tests::readings), name) {
    const auto table = lga::compile(tests::reading(name, 0.3));
    for (unsigned packed = 0; packed < lga::site_states; ++packed) {
        Distribution all;
        collect(table, table.roots[packed], 1, all);
        const lga::SiteState before{.movers = static_cast<std::uint8_t>(packed & 63U),
                                    .rests = static_cast<std::uint8_t>(packed >> 6)};
        double sum = 0;
        for (const auto& [o, probability] : all) {
            const lga::SiteState after{.movers = static_cast<std::uint8_t>(o[0]),
                                       .rests = static_cast<std::uint8_t>(o[1])};
            BOOST_TEST(lga::mass(after) == lga::mass(before));
            BOOST_TEST((lga::momentum(after.movers) == lga::momentum(before.movers)));
            sum += probability;
        }
        BOOST_TEST(std::abs(sum - 1) < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(two_head_on_turn_or_stop_and_one_returns_where_it_came_from) {
    constexpr double p = 0.8;
    check(outcomes(tests::reading("P", p), tests::at(0, {0, 3})),
          {{{1 << 1 | 1 << 4, 0, 0}, (1 - p) / 2},
           {{1 << 2 | 1 << 5, 0, 0}, (1 - p) / 2},
           {{0, 2, 1 << 0}, p / 2},
           {{0, 2, 1 << 3}, p / 2}});
}

BOOST_AUTO_TEST_CASE(of_three_that_stop_two_return_every_pair_equally_likely) {
    constexpr double p = 0.6;
    check(outcomes(tests::reading("P", p), tests::at(0, {0, 2, 4})),
          {{{1 << 1 | 1 << 3 | 1 << 5, 0, 0}, 1 - p},
           {{0, 3, 1 << 3 | 1 << 5}, p / 3},
           {{0, 3, 1 << 3 | 1 << 1}, p / 3},
           {{0, 3, 1 << 5 | 1 << 1}, p / 3}});
}

BOOST_AUTO_TEST_CASE(without_origins_excess_rests_stay_to_walk) {
    check(outcomes(tests::reading("D", 1), tests::at(0, {0, 3}, 1)), {{{0, 3, 0}, 1}});
}

BOOST_AUTO_TEST_CASE(spectators_stay_and_block_what_they_fill) {
    // 0 and 3 collide beside 1: the turn to 1 4 is blocked, and its probability stays with "none".
    constexpr double p = 0.5;
    const int spectator = 1 << 1;
    check(outcomes(tests::reading("M", p), tests::at(0, {0, 1, 3})),
          {{{1 << 0 | 1 << 1 | 1 << 3, 0, 0}, (1 - p) / 2},
           {{spectator | 1 << 2 | 1 << 5, 0, 0}, (1 - p) / 2},
           {{spectator, 2, 0}, p}});
    check(outcomes(tests::reading("P", p), tests::at(0, {0, 1, 3})),
          {{{1 << 0 | 1 << 1 | 1 << 3, 0, 0}, 1}});
}

BOOST_AUTO_TEST_CASE(of_two_collisions_that_apply_each_is_as_likely) {
    // Two pairs head on: either stops with p, and neither has room to turn but past the other.
    check(outcomes(tests::reading("M", 1), tests::at(0, {0, 1, 3, 4})),
          {{{1 << 0 | 1 << 3, 2, 0}, 0.5}, {{1 << 1 | 1 << 4, 2, 0}, 0.5}});
}

BOOST_AUTO_TEST_CASE(the_order_of_the_rows_does_not_matter) {
    auto model = tests::reading("M", 0.3);
    const auto table = lga::compile(model);
    std::ranges::reverse(model.rules);
    const auto reversed = lga::compile(model);
    BOOST_TEST((table.decisions == reversed.decisions));
    BOOST_TEST((table.outcomes == reversed.outcomes));
    BOOST_TEST((table.roots == reversed.roots));
}

BOOST_AUTO_TEST_CASE(a_row_that_breaks_conservation_is_refused_with_its_place) {
    const auto mass = refusal({{0b000001, 0}, {0b000011, 0}, 0.5});
    BOOST_TEST(contains(mass, "mine.toml:3"), mass);
    BOOST_TEST(contains(mass, "'0' -> '0 1'"), mass);
    BOOST_TEST(contains(mass, "does not conserve mass"), mass);
    const auto momentum = refusal({{0b000001, 0}, {0b001000, 0}, 0.5});
    BOOST_TEST(contains(momentum, "does not conserve momentum"), momentum);
    BOOST_TEST(momentum.find('\n') == std::string::npos);
}

BOOST_AUTO_TEST_CASE(rows_that_make_no_sense_are_refused) {
    BOOST_TEST(contains(refusal({{0, 2}, {0, 2}, 0.5}), "too many particles at rest"));
    BOOST_TEST(contains(refusal({{3, 0}, {3, 0}, 1.5}), "probability out of range"));
    BOOST_TEST(
        contains(refusal({tests::at(0, {0, 3}), tests::at(0, {1, 4}), 0.3}), "together exceed 1"));
    BOOST_TEST(contains(
        refusal({tests::at(0, {0, 3}), tests::at(0, {1, 4}), 0, lga::Matching::spectators}),
        "spectators in some rows only"));
}
