// Damage spreading: a twin that differs at a few nodes and runs with the same random numbers.
#include "native/base/errors.hpp"
#include "native/hopper/initial_state.hpp"
#include "tests/native/hopper/hoppers.hpp"

using namespace crossgrain;
using namespace crossgrain::tests;
using hopper::EngineKind;
using hopper::RandomSource;

namespace {

std::size_t differences(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += a[i] != b[i];
    return count;
}

}  // namespace

BOOST_AUTO_TEST_CASE(exactly_the_asked_for_number_of_nodes_is_flipped) {
    auto p = small_hopper();
    const auto original = initial_state(p, 1000);
    for (const int flipped : {0, 1, 2, 3, 4, 8, 1000}) {
        p.flipped = flipped;
        const auto twin = initial_state(p, 1000);
        BOOST_TEST(differences(original, twin) == static_cast<std::size_t>(flipped));
        for (const auto s : twin)
            BOOST_REQUIRE((s >= 1 && s <= 3));
    }
    p.flipped = 1001;
    BOOST_CHECK_THROW((void)initial_state(p, 1000), CaseError);
}

BOOST_AUTO_TEST_CASE(a_twin_without_flips_stays_identical) {
    auto p = small_hopper();
    for (const auto random : {RandomSource::per_site, RandomSource::shared_stream}) {
        p.random = random;
        p.flipped = 0;
        BOOST_TEST((trajectory(p, EngineKind::fast, 40) == trajectory(p, EngineKind::fast, 40)));
    }
}

BOOST_AUTO_TEST_CASE(a_flip_that_no_hole_meets_stays_a_single_one) {
    // Two holes pass some 2000 of 15,000 sites; a flip anywhere else is left alone.
    auto p = small_hopper();
    p.levels = 400;
    p.outlet = 2;
    int left_alone = 0;
    for (p.run = 0; p.run < 10; ++p.run) {
        p.flipped = 0;
        const auto original = trajectory(p, EngineKind::fast, 1);
        p.flipped = 1;
        const auto twin = trajectory(p, EngineKind::fast, 1);
        BOOST_TEST(differences(original.states[0], twin.states[0]) == 1);
        left_alone += differences(original.states[1], twin.states[1]) == 1;
    }
    BOOST_TEST(left_alone >= 5);
}

BOOST_AUTO_TEST_CASE(one_shared_stream_spreads_damage_further_than_numbers_of_each_site) {
    // One tie more shifts all later numbers of a shared stream, everywhere.
    auto p = small_hopper();
    p.rules.c_d = 0.5;
    std::size_t damage[2] = {0, 0};
    for (p.run = 0; p.run < 8; ++p.run) {
        for (const auto random : {RandomSource::per_site, RandomSource::shared_stream}) {
            p.random = random;
            p.flipped = 0;
            const auto original = trajectory(p, EngineKind::fast, 40).states.back();
            p.flipped = 8;
            const auto twin = trajectory(p, EngineKind::fast, 40).states.back();
            damage[random == RandomSource::shared_stream] += differences(original, twin);
        }
    }
    BOOST_TEST(damage[0] > 0);
    BOOST_TEST(damage[1] > damage[0]);
}
