#include "native/hopper/level_order.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "native/hopper/level_order.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace crossgrain::hopper::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Words = hn::ScalableTag<std::uint32_t>;
using Vector = hn::Vec<Words>;

struct Product {
    Vector high, low;
};

/// All 64 bits of `factor` times each lane.
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Product multiply(Vector factor, Vector lanes) {
    const Words d;
    const std::uint64_t product = std::uint64_t{hn::GetLane(factor)} * hn::GetLane(lanes);
    return {.high = hn::Set(d, static_cast<std::uint32_t>(product >> 32)),
            .low = hn::Set(d, static_cast<std::uint32_t>(product))};
}
#else
HWY_INLINE Product multiply(Vector factor, Vector lanes) {
    const Words d;
    const hn::Repartition<std::uint64_t, Words> pairs;
    const auto even = hn::MulEven(lanes, factor);
    const auto odd =
        hn::MulEven(hn::BitCast(d, hn::ShiftRight<32>(hn::BitCast(pairs, lanes))), factor);
    return {.high = hn::OddEven(hn::BitCast(d, odd), hn::BitCast(d, hn::ShiftRight<32>(even))),
            .low = hn::OddEven(hn::BitCast(d, hn::ShiftLeft<32>(odd)), hn::BitCast(d, even))};
}
#endif

/// The first two words of Philox4x32-7 for counters that differ in their first word only.
HWY_INLINE void order_and_tie(const IterationNumbers& n, Vector site, Vector& order, Vector& tie) {
    constexpr std::size_t rounds = IterationNumbers::rounds;
    const Words d;
    const auto m0 = hn::Set(d, PHILOX_M4x32_0), m1 = hn::Set(d, PHILOX_M4x32_1);
    const Product first = multiply(m0, site);
    const Product second = multiply(m1, hn::Xor(first.high, hn::Set(d, n.first_2)));
    auto w0 = hn::Xor(second.high, hn::Set(d, n.second_0));
    auto w1 = second.low;
    auto w2 = hn::Xor(first.low, hn::Set(d, n.second_2));
    auto w3 = hn::Set(d, n.second_3);
    for (std::size_t round = 2; round + 1 < rounds; ++round) {
        const Product a = multiply(m0, w0), b = multiply(m1, w2);
        w0 = hn::Xor3(b.high, w1, hn::Set(d, n.key_0[round]));
        w1 = b.low;
        w2 = hn::Xor3(a.high, w3, hn::Set(d, n.key_1[round]));
        w3 = a.low;
    }
    const Product last = multiply(m1, w2);
    order = hn::Xor3(last.high, w1, hn::Set(d, n.key_0[rounds - 1]));
    tie = last.low;
}

/// Rank: how many have a smaller number. Whole vectors, the lanes beyond the last hole having the
/// largest of all numbers. Returns whether no two numbers are equal.
HWY_INLINE bool rank_holes(const LevelNumbers& numbers, std::size_t count) {
    const Words d;
    const auto one = hn::Set(d, 1U);
    auto sums = hn::Zero(d);
    std::size_t lanes = 0;
    for (; lanes < count; lanes += hn::Lanes(d)) {
        const auto mine = hn::LoadU(d, numbers.order + lanes);
        auto rank = hn::Zero(d);
        for (std::size_t j = 0; j < count; j += order_block) {
            for (std::size_t i = j; i < j + order_block; ++i) {
                const auto smaller = hn::Lt(hn::Set(d, numbers.order[i]), mine);
                rank = hn::Add(rank, hn::IfThenElseZero(smaller, one));
            }
        }
        hn::StoreU(rank, d, numbers.rank + lanes);
        sums = hn::Add(sums, rank);
    }
    // Equal numbers lower the sum of the ranks.
    const std::size_t sum = hn::GetLane(hn::SumOfLanes(d, sums));
    return sum == count * (count - 1) / 2 + (lanes - count) * count;
}

bool NumberHoles(const LevelHoles& holes, const IterationNumbers& iteration,
                 std::uint32_t site_of_place, const LevelNumbers& numbers) {
    const Words d;
    const auto to_site = hn::Set(d, site_of_place);
    std::size_t i = 0;
    for (; i < holes.count; i += hn::Lanes(d)) {
        Vector order, tie;
        order_and_tie(iteration, hn::Add(hn::LoadU(d, holes.place + i), to_site), order, tie);
        hn::StoreU(order, d, numbers.order + i);
        hn::StoreU(tie, d, numbers.tie + i);
    }
    for (i = holes.count; i < holes.count + order_block; i += hn::Lanes(d)) {
        hn::StoreU(hn::Set(d, ~0U), d, numbers.order + i);
    }
    return rank_holes(numbers, holes.count);
}

}  // namespace crossgrain::hopper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace crossgrain::hopper {
namespace {

HWY_EXPORT(NumberHoles);

/// For equal numbers, which rank_holes cannot tell apart.
void rank_by_order_and_place(const LevelHoles& holes, const LevelNumbers& numbers) {
    std::vector<std::uint32_t> sorted(holes.count);
    std::iota(sorted.begin(), sorted.end(), 0U);
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(numbers.order[a], holes.place[a]) <
               std::pair(numbers.order[b], holes.place[b]);
    });
    for (std::uint32_t rank = 0; rank < sorted.size(); ++rank)
        numbers.rank[sorted[rank]] = rank;
}

}  // namespace

IterationNumbers::IterationNumbers(const Numbers& numbers, std::uint32_t iteration) {
    std::uint32_t k0 = numbers.key()[0], k1 = numbers.key()[1];
    const auto next_key = [&] {
        k0 += PHILOX_W32_0;
        k1 += PHILOX_W32_1;
    };
    // Counter: site, iteration, run, purpose. Only word 0 differs from site to site.
    const std::uint64_t of_run = std::uint64_t{PHILOX_M4x32_1} * numbers.run();
    first_2 = static_cast<std::uint32_t>(Purpose::moves) ^ k1;
    const std::uint32_t word_0 = static_cast<std::uint32_t>(of_run >> 32) ^ iteration ^ k0;
    next_key();
    // Words 0 and 1 are still the same for all.
    const std::uint64_t of_word_0 = std::uint64_t{PHILOX_M4x32_0} * word_0;
    second_0 = static_cast<std::uint32_t>(of_run) ^ k0;
    second_2 = static_cast<std::uint32_t>(of_word_0 >> 32) ^ k1;
    second_3 = static_cast<std::uint32_t>(of_word_0);
    for (std::size_t round = 2; round < rounds; ++round) {
        next_key();
        key_0[round] = k0;
        key_1[round] = k1;
    }
}

void number_holes(const LevelHoles& holes, const IterationNumbers& iteration,
                  std::uint32_t site_of_place, const LevelNumbers& numbers) {
    const bool different =
        HWY_DYNAMIC_DISPATCH(NumberHoles)(holes, iteration, site_of_place, numbers);
    if (!different) rank_by_order_and_place(holes, numbers);
}

}  // namespace crossgrain::hopper
#endif
