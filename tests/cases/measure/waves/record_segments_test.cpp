// Series leave a segment as they came in, minus their mean, and their transform is the textbook's.
#include "cases/measure/statistics/pair_transform.hpp"
#include "cases/measure/waves/record_segments.hpp"
#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace crossgrain;

namespace {

constexpr std::size_t bins = 4, replicas = 7, points = 64;

std::uint16_t count(std::size_t t, std::size_t series) {
    return static_cast<std::uint16_t>(
        100 * uniform(5, RandomStream::jitter, t * bins * replicas + series) +
        static_cast<double>(series));
}

std::vector<std::uint16_t> frame(std::size_t t) {
    std::vector<std::uint16_t> counts;
    for (std::size_t s = 0; s < bins * replicas; ++s)
        counts.push_back(count(t, s));
    return counts;
}

double mean_of(std::size_t series, std::size_t from, std::size_t to) {
    double sum = 0;
    for (std::size_t t = from; t < to; ++t)
        sum += count(t, series);
    return sum / static_cast<double>(to - from);
}

}  // namespace

BOOST_AUTO_TEST_CASE(series_come_out_in_pairs_without_their_mean) {
    measure::RecordSegments segments({.first = 1, .last = 3}, replicas, points);
    BOOST_TEST(segments.series() == 21U);
    BOOST_TEST(segments.pairs() == 11U);
    for (std::size_t t = 0; t < points; ++t)
        BOOST_TEST(segments.add(frame(t)) == (t + 1 == points));
    std::vector<std::complex<float>> out(points);
    for (std::size_t pair = 0; pair < segments.pairs(); ++pair) {
        segments.pair(pair, 0, out);
        const std::size_t first = replicas + 2 * pair, second = first + 1;
        for (std::size_t t = 0; t < points; ++t) {
            BOOST_TEST(std::abs(out[t].real() - (count(t, first) - mean_of(first, 0, points))) <
                       1e-4);
            if (2 * pair + 1 == segments.series()) {
                BOOST_TEST(out[t].imag() == 0);
            } else {
                BOOST_TEST(std::abs(out[t].imag() -
                                    (count(t, second) - mean_of(second, 0, points))) < 1e-4);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_full_segment_is_followed_by_a_new_one) {
    measure::RecordSegments segments({.first = 0, .last = 3}, replicas, points);
    std::vector<std::complex<float>> out(points);
    for (std::size_t t = 0; t < 2 * points; ++t)
        BOOST_TEST(segments.add(frame(t)) == ((t + 1) % points == 0));
    segments.pair(0, 0, out);
    BOOST_TEST(std::abs(out[3].real() - (count(points + 3, 0) - mean_of(0, points, 2 * points))) <
               1e-4);
}

BOOST_AUTO_TEST_CASE(a_running_mean_is_that_of_the_frames_around) {
    measure::RecordSegments segments({.first = 0, .last = 3}, replicas, points);
    for (std::size_t t = 0; t < points; ++t)
        segments.add(frame(t));
    std::vector<std::complex<float>> out(points);
    segments.pair(2, 9, out);
    BOOST_TEST(std::abs(out[20].real() - (count(20, 4) - mean_of(4, 16, 25))) < 1e-4);
    BOOST_TEST(std::abs(out[2].imag() - (count(2, 5) - mean_of(5, 0, 7))) < 1e-4);
    BOOST_TEST(std::abs(out[63].imag() - (count(63, 5) - mean_of(5, 59, 64))) < 1e-4);
}

BOOST_AUTO_TEST_CASE(the_transform_of_a_pair_is_that_of_each) {
    measure::PairTransform transform(points);
    std::vector<std::complex<double>> first(points / 2 + 1), second(points / 2 + 1);
    for (std::size_t t = 0; t < points; ++t) {
        const auto [a, b] = normal_pair(9, RandomStream::jitter, t);
        transform.input()[t] = {static_cast<float>(a), static_cast<float>(b)};
        for (std::size_t k = 0; k <= points / 2; ++k) {
            const auto phase = std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k * t) /
                                                   static_cast<double>(points));
            first[k] += a * phase;
            second[k] += b * phase;
        }
    }
    transform.forward();
    std::vector<double> power_a(points / 2 + 1, 1.0), power_b(points / 2 + 1, 0.0);
    transform.add_power(power_a, power_b);
    for (std::size_t k = 0; k <= points / 2; ++k) {
        const auto [a, b] = transform.at(k);
        BOOST_TEST(std::abs(std::complex<double>(a) - first[k]) < 1e-4);
        BOOST_TEST(std::abs(std::complex<double>(b) - second[k]) < 1e-4);
        BOOST_TEST(std::abs(power_a[k] - 1 - std::norm(first[k])) < 1e-3);
        BOOST_TEST(std::abs(power_b[k] - std::norm(second[k])) < 1e-3);
    }
}
