// The random numbers: uniform, the same however many are made at a time, and different for each
// site, iteration, run and purpose.
#include "native/hopper/initial_state.hpp"
#include "native/hopper/level_order.hpp"
#include "native/hopper/numbers.hpp"
#include "tests/native/hopper/hoppers.hpp"

#include <hwy/highway.h>

#include <algorithm>
#include <map>
#include <set>

using namespace crossgrain;
using namespace crossgrain::tests;
using namespace crossgrain::hopper;

namespace {

/// Pearson's sum for equally likely bins.
double chi_square(const std::vector<int>& counts) {
    double total = 0;
    for (const int count : counts)
        total += count;
    const double expected = total / static_cast<double>(counts.size());
    double sum = 0;
    for (const int count : counts)
        sum += (count - expected) * (count - expected) / expected;
    return sum;
}

/// Five standard deviations above the mean of chi-square; the numbers are fixed, so this fails
/// for ever or never.
double largest_chi_square(std::size_t bins) {
    const auto freedom = static_cast<double>(bins - 1);
    return freedom + 5 * std::sqrt(2 * freedom);
}

struct Numbered {
    std::vector<std::uint32_t> order, tie, rank;
};

Numbered number(std::vector<std::uint32_t> places, const Numbers& numbers, std::uint32_t iteration,
                std::uint32_t site_of_place) {
    const std::size_t count = places.size();
    Numbered n;
    for (auto* v : {&places, &n.order, &n.tie, &n.rank})
        v->resize(count + order_padding);
    number_holes({.place = places.data(), .count = count}, IterationNumbers(numbers, iteration),
                 site_of_place,
                 {.order = n.order.data(), .tie = n.tie.data(), .rank = n.rank.data()});
    for (auto* v : {&n.order, &n.tie, &n.rank})
        v->resize(count);
    return n;
}

}  // namespace

BOOST_AUTO_TEST_CASE(ties_are_broken_uniformly) {
    const Numbers numbers(small_hopper());
    for (std::uint32_t candidates = 2; candidates <= 9; ++candidates) {
        std::vector<int> counts(candidates);
        for (std::uint32_t iteration = 0; iteration < 100; ++iteration) {
            for (std::uint32_t site = 0; site < 1000; ++site) {
                ++counts[choose(numbers.of_move(iteration, site).tie, candidates)];
            }
        }
        BOOST_TEST(chi_square(counts) < largest_chi_square(candidates));
    }
}

BOOST_AUTO_TEST_CASE(without_energies_all_new_orientations_are_as_likely) {
    // The same through an engine: only ties, all over the hopper.
    auto p = small_hopper();
    p.outlet = 40;
    p.rules = {.c_d = 0, .c_o = 0, .c_i = 0, .c_w = 0};
    const auto engine = make_engine(p, EngineKind::fast);
    std::vector<int> counts(3);
    for (int i = 0; i < 50; ++i) {
        engine->advance(1);
        const auto state = engine->state();
        for (std::size_t site = 0; site < 40; ++site)
            ++counts[state[site] - 1U];
    }
    BOOST_TEST(chi_square(counts) < largest_chi_square(3));
}

BOOST_AUTO_TEST_CASE(every_order_of_the_holes_of_a_level_is_as_likely) {
    const Numbers numbers(small_hopper());
    std::map<std::vector<std::uint32_t>, int> orders;
    for (std::uint32_t iteration = 0; iteration < 24'000; ++iteration) {
        ++orders[number({10, 11, 12, 13}, numbers, iteration, 5).rank];
    }
    BOOST_TEST(orders.size() == 24);
    std::vector<int> counts;
    for (const auto& [order, count] : orders)
        counts.push_back(count);
    BOOST_TEST(chi_square(counts) < largest_chi_square(24));
}

BOOST_AUTO_TEST_CASE(many_at_a_time_are_the_same_numbers_on_every_kind_of_processor) {
    auto p = small_hopper();
    p.seed = 0x123456789abcdefULL;
    p.run = 77;
    const Numbers numbers(p);
    for (const auto target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        for (std::uint32_t count = 1; count < 70; ++count) {
            std::vector<std::uint32_t> places(count);
            for (std::uint32_t i = 0; i < count; ++i)
                places[i] = 1000 + 37 * i % 211;
            const auto got = number(places, numbers, count, 5U - 1000U);
            std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted(count);
            for (std::size_t i = 0; i < count; ++i) {
                const auto [order, tie] = numbers.of_move(count, places[i] + 5U - 1000U);
                BOOST_TEST(got.order[i] == order);
                BOOST_TEST(got.tie[i] == tie);
                sorted[i] = {order, places[i]};
            }
            std::sort(sorted.begin(), sorted.end());
            for (std::size_t i = 0; i < count; ++i) {
                BOOST_TEST(sorted[got.rank[i]].second == places[i]);
            }
        }
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

BOOST_AUTO_TEST_CASE(equal_numbers_still_give_every_hole_a_rank_of_its_own) {
    // The same place twice has the same number twice; by chance it happens once in 10^8 levels.
    const Numbers numbers(small_hopper());
    auto ranks = number({3, 9, 3, 4, 9}, numbers, 0, 0).rank;
    std::sort(ranks.begin(), ranks.end());
    BOOST_TEST((ranks == std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

BOOST_AUTO_TEST_CASE(site_iteration_run_seed_and_purpose_all_matter) {
    std::set<std::uint32_t> seen;
    auto p = small_hopper();
    for (p.seed = 1; p.seed <= 2; ++p.seed) {
        for (p.run = 0; p.run < 2; ++p.run) {
            const Numbers numbers(p);
            for (std::uint32_t i = 0; i < 2; ++i) {
                for (std::uint32_t site = 0; site < 2; ++site) {
                    seen.insert(numbers.of_move(i, site).order);
                    seen.insert(numbers.of_move(i, site).tie);
                }
                seen.insert(numbers.of_stream(i));
                seen.insert(numbers.block(i, 0, Purpose::initial_state)[0]);
            }
        }
    }
    BOOST_TEST(seen.size() == 4U * (2 * 2 * 2 + 2 + 2));
}

BOOST_AUTO_TEST_CASE(initial_orientations_are_uniform_and_independent_of_their_neighbours) {
    const auto state = initial_state(small_hopper(), 90'000);
    std::vector<int> single(3), pairs(9);
    for (std::size_t i = 0; i + 1 < state.size(); i += 2) {
        ++single[state[i] - 1U];
        ++pairs[3U * (state[i] - 1U) + state[i + 1] - 1U];
    }
    BOOST_TEST(chi_square(single) < largest_chi_square(3));
    BOOST_TEST(chi_square(pairs) < largest_chi_square(9));
    // The judge: a filling that is no mixture must not pass.
    BOOST_TEST(chi_square({300, 330, 370}) > 7.0);
    BOOST_TEST(chi_square({20'000, 10'000, 15'000}) > largest_chi_square(3));
}
