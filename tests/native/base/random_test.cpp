// The random numbers are the published generator, a pure function of (seed, stream, n), and have
// the moments they claim. Statistical bounds are five standard errors of the statistic: a fixed
// seed gives a fixed answer, and a wrong distribution is tens of standard errors away.
#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;

namespace {

using Words4 = std::array<std::uint32_t, 4>;
using Words2 = std::array<std::uint32_t, 2>;

constexpr std::uint64_t samples = 200000;

struct KnownAnswer {
    Words4 counter;
    Words2 key;
    Words4 answer;
};

// File kat_vectors of Random123 1.14, lines "philox4x32 10".
constexpr std::array<KnownAnswer, 3> published{
    {{{0, 0, 0, 0}, {0, 0}, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
     {{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
      {0xffffffff, 0xffffffff},
      {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
     {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
      {0xa4093822, 0x299f31d0},
      {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}}}};

/// Philox4x32-10 written from the paper (Salmon et al. 2011, sec. 3.3), for a second opinion.
Words4 philox(Words4 c, Words2 key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t a = std::uint64_t{0xD2511F53} * c[0];
        const std::uint64_t b = std::uint64_t{0xCD9E8D57} * c[2];
        c = {static_cast<std::uint32_t>(b >> 32) ^ c[1] ^ key[0], static_cast<std::uint32_t>(b),
             static_cast<std::uint32_t>(a >> 32) ^ c[3] ^ key[1], static_cast<std::uint32_t>(a)};
        key[0] += 0x9E3779B9U;
        key[1] += 0xBB67AE85U;
    }
    return c;
}

/// Middle of the 2^-53 wide interval that two words name.
double in_unit(std::uint32_t high, std::uint32_t low) {
    const std::uint64_t word = (std::uint64_t{high} << 32) | low;
    return std::ldexp(static_cast<double>(word >> 11) + 0.5, -53);
}

Words4 words(std::uint64_t seed, RandomStream stream, std::uint64_t n) {
    return philox({static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n >> 32),
                   static_cast<std::uint32_t>(stream), 0},
                  {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
}

const std::vector<std::uint64_t> numbers{0, 1, 77, 0xffffffff, 0x100000000, 0xfedcba9876543210};

}  // namespace

BOOST_AUTO_TEST_CASE(the_installed_generator_gives_the_published_vectors) {
    for (const auto& known : published) {
        r123::Philox4x32 generator;
        r123::Philox4x32::ctr_type counter{};
        r123::Philox4x32::key_type key{};
        for (std::size_t i = 0; i < 4; ++i)
            counter[i] = known.counter[i];
        for (std::size_t i = 0; i < 2; ++i)
            key[i] = known.key[i];
        const auto answer = generator(counter, key);
        for (std::size_t i = 0; i < 4; ++i)
            BOOST_TEST(answer[i] == known.answer[i]);
        BOOST_TEST(philox(known.counter, known.key) == known.answer, tt::per_element());
    }
}

BOOST_AUTO_TEST_CASE(numbers_are_the_published_generator_s_for_seed_stream_and_n) {
    // Seed, stream and n all zero are the first published vector.
    BOOST_TEST(uniform(0, RandomStream{0}, 0) == in_unit(0x6627e8d5, 0xe169c58d));
    for (const auto seed : numbers) {
        for (const auto n : numbers) {
            const auto w = words(seed, RandomStream::jitter, n);
            BOOST_TEST(uniform(seed, RandomStream::jitter, n) == in_unit(w[0], w[1]));
            const double radius = std::sqrt(-2 * std::log(in_unit(w[0], w[1])));
            const double angle = 2 * std::numbers::pi * in_unit(w[2], w[3]);
            const auto pair = normal_pair(seed, RandomStream::jitter, n);
            BOOST_TEST(pair[0] == radius * std::cos(angle));
            BOOST_TEST(pair[1] == radius * std::sin(angle));
        }
    }
}

BOOST_AUTO_TEST_CASE(the_same_seed_stream_and_n_give_the_same_number_in_any_order) {
    std::vector<double> forward;
    for (std::uint64_t n = 0; n < 1000; ++n)
        forward.push_back(uniform(5, RandomStream::initial_position, n));
    for (std::uint64_t n = 1000; n-- > 0;)
        BOOST_TEST(uniform(5, RandomStream::initial_position, n) == forward[n]);
}

BOOST_AUTO_TEST_CASE(streams_seeds_and_numbers_never_share_a_value) {
    std::vector<double> all;
    for (const auto stream :
         {RandomStream::initial_velocity, RandomStream::initial_position, RandomStream::jitter}) {
        for (const auto seed : numbers) {
            for (const auto n : numbers)
                all.push_back(uniform(seed, stream, n));
        }
    }
    // 108 numbers of 53 bits: a coincidence has a chance of 1e-12.
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            BOOST_TEST(all[i] != all[j]);
    }
}

BOOST_AUTO_TEST_CASE(streams_are_uncorrelated) {
    double sum = 0;
    for (std::uint64_t n = 0; n < samples; ++n) {
        sum += (uniform(1, RandomStream::initial_position, n) - 0.5) *
               (uniform(1, RandomStream::jitter, n) - 0.5);
    }
    const auto count = static_cast<double>(samples);
    BOOST_TEST(std::abs(sum / count * 12) < 5 / std::sqrt(count));
}

BOOST_AUTO_TEST_CASE(uniform_has_the_moments_of_the_unit_interval_and_no_end_points) {
    double sum = 0, squares = 0;
    bool inside = true;
    for (std::uint64_t n = 0; n < samples; ++n) {
        const double u = uniform(1, RandomStream::jitter, n);
        inside = inside && u > 0 && u < 1;
        sum += u;
        squares += (u - 0.5) * (u - 0.5);
    }
    const auto count = static_cast<double>(samples);
    BOOST_TEST(inside);
    BOOST_TEST(std::abs(sum / count - 0.5) < 5 * std::sqrt(1.0 / 12 / count));
    BOOST_TEST(std::abs(squares / count - 1.0 / 12) < 5 * std::sqrt(1.0 / 180 / count));
}

BOOST_AUTO_TEST_CASE(uniform_fills_the_unit_interval_evenly) {
    constexpr std::size_t bins = 128;
    std::array<double, bins> found{};
    for (std::uint64_t n = 0; n < samples; ++n) {
        const double u = uniform(2, RandomStream::initial_position, n);
        found[static_cast<std::size_t>(u * bins)] += 1;
    }
    const double expected = static_cast<double>(samples) / bins;
    double chi_squared = 0;
    for (const double count : found)
        chi_squared += (count - expected) * (count - expected) / expected;
    // Mean 127, standard deviation sqrt(2 * 127): too even is as wrong as too uneven.
    BOOST_TEST(std::abs(chi_squared - (bins - 1)) < 5 * std::sqrt(2.0 * (bins - 1)));
}

BOOST_AUTO_TEST_CASE(normal_pair_is_two_independent_standard_normal_deviates) {
    std::array<double, 2> sum{}, squares{}, fourth{};
    double product = 0, beyond_three = 0;
    for (std::uint64_t n = 0; n < samples; ++n) {
        const auto pair = normal_pair(3, RandomStream::initial_velocity, n);
        for (std::size_t i = 0; i < 2; ++i) {
            sum[i] += pair[i];
            squares[i] += pair[i] * pair[i];
            fourth[i] += std::pow(pair[i], 4);
            if (std::abs(pair[i]) > 3) beyond_three += 1;
        }
        product += pair[0] * pair[1];
    }
    const auto count = static_cast<double>(samples);
    for (std::size_t i = 0; i < 2; ++i) {
        BOOST_TEST(std::abs(sum[i] / count) < 5 / std::sqrt(count));
        BOOST_TEST(std::abs(squares[i] / count - 1) < 5 * std::sqrt(2 / count));
        BOOST_TEST(std::abs(fourth[i] / count - 3) < 5 * std::sqrt(96 / count));
    }
    BOOST_TEST(std::abs(product / count) < 5 / std::sqrt(count));
    // erfc(3 / sqrt(2)) = 0.0027 of all, with the error of a count.
    const double expected = 2 * count * std::erfc(3 / std::numbers::sqrt2);
    BOOST_TEST(std::abs(beyond_three - expected) < 5 * std::sqrt(expected));
}
