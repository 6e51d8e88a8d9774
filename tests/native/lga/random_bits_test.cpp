// The random bits are those of Random123's ARS4x32-7, in plain C++ and in vectors, and decisions
// made with them have the probability that was asked for.
#include "native/lga/ars_portable.hpp"
#include "native/lga/ensemble.hpp"
#include "native/lga/probability.hpp"
#include "native/lga/random_bits.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

using namespace crossgrain;

namespace {

using Block = std::array<std::uint64_t, 2>;

Block block(const lga::RoundKeys& keys, lga::Counter counter) {
    return lga::portable_block(keys, counter);
}

}  // namespace

BOOST_AUTO_TEST_CASE(known_answers_of_random123) {
    // ars4x32_R(7, counter, key) of Random123 1.14, key {seed, use}, read as 64-bit words.
    const lga::RoundKeys one(1, lga::RandomUse::dynamics);
    BOOST_TEST(
        (block(one, {.low = 0, .high = 0}) == Block{0x943e8ded8c489f72ULL, 0xd034fe63bb0375b7ULL}));
    BOOST_TEST((block(one, {.low = 0x0123456789abcdef, .high = 0xfedcba9876543210}) ==
                Block{0x19359285e7336dafULL, 0xcdcf96ed7ddd081aULL}));
    const lga::RoundKeys other(0xfeedfacecafebeef, lga::RandomUse::initial_state);
    BOOST_TEST((block(other, {.low = ~0ULL, .high = ~0ULL}) ==
                Block{0x5e019621534f5c85ULL, 0x5a09ee7f722702dbULL}));
}

BOOST_AUTO_TEST_CASE(the_processors_rounds_and_plain_c_plus_plus_agree) {
    const lga::RoundKeys keys(42, lga::RandomUse::dynamics);
    for (std::uint64_t n = 0; n < 2000; ++n) {
        const lga::Counter first{.low = n * 0x9E3779B97F4A7C15ULL, .high = n << 13};
        const auto fast = lga::random_blocks(keys, first);
        for (std::uint64_t i = 0; i < 4; ++i) {
            BOOST_TEST_REQUIRE(
                (fast[i] == block(keys, {.low = first.low, .high = first.high + i})));
        }
    }
}

BOOST_AUTO_TEST_CASE(counters_of_steps_sites_draws_and_blocks_never_coincide) {
    const auto a = lga::counter(std::int64_t{1} << 32, 0, 0);
    const auto b = lga::counter(0, 0, 0);
    BOOST_TEST((a.low != b.low || a.high != b.high));
    const auto site = lga::counter(5, 7, 0), block_1 = lga::counter(5, 7, 1);
    BOOST_TEST(site.low == block_1.low);
    BOOST_TEST(site.high != block_1.high);
    BOOST_TEST(lga::counter(5, 8, 0).low != site.low);
    // The draws of a site have the low half of `high` for themselves.
    BOOST_TEST((site.high & 0xffffffffU) == 0U);
}

BOOST_AUTO_TEST_CASE(probabilities_keep_24_bits) {
    for (const double p : {0.1, 0.2, 1.0 / 3, 0.8, 0.123456789}) {
        BOOST_TEST(std::abs(lga::fixed_point(p) / 16777216.0 - p) <= 0x1p-25);
    }
    BOOST_TEST(lga::fixed_point(1) == lga::certain);
    BOOST_TEST(lga::deciding_bits(lga::fixed_point(0.5)) == 1);
    BOOST_TEST(lga::deciding_bits(lga::fixed_point(0.25)) == 2);
    BOOST_TEST(lga::deciding_bits(lga::fixed_point(0.8)) > 16);
    BOOST_TEST(lga::deciding_bits(0) == 0);
    BOOST_TEST(lga::deciding_bits(lga::certain) == 0);
}

BOOST_AUTO_TEST_CASE(all_bits_are_balanced_and_independent_of_their_neighbours) {
    const lga::RoundKeys keys(7, lga::RandomUse::dynamics);
    constexpr int draws = 20000;
    std::array<int, 128> ones{};
    std::int64_t equal_to_next_draw = 0, equal_to_next_site = 0;
    for (int n = 0; n < draws; ++n) {
        const auto here = block(keys, {.low = static_cast<std::uint64_t>(n), .high = 0});
        const auto draw = block(keys, {.low = static_cast<std::uint64_t>(n), .high = 1});
        const auto site =
            block(keys, {.low = static_cast<std::uint64_t>(n) + (1ULL << 32), .high = 0});
        for (std::size_t w = 0; w < 2; ++w) {
            for (std::size_t b = 0; b < 64; ++b)
                ones[64 * w + b] += static_cast<int>(here[w] >> b & 1);
            equal_to_next_draw += std::popcount(~(here[w] ^ draw[w]));
            equal_to_next_site += std::popcount(~(here[w] ^ site[w]));
        }
    }
    // Five standard deviations; fixed seed.
    for (const int n : ones)
        BOOST_TEST(std::abs(n - draws / 2) < 5 * std::sqrt(draws) / 2);
    const double all = 128.0 * draws;
    for (const auto n : {equal_to_next_draw, equal_to_next_site}) {
        BOOST_TEST(std::abs(static_cast<double>(n) - all / 2) < 5 * std::sqrt(all) / 2);
    }
}
