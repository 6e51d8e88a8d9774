// Periodograms of rows with known transforms, also from several threads at once.
#include "cases/measure/bed/layer_spectrum.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <complex>
#include <numbers>
#include <thread>
#include <vector>

using namespace crossgrain;

namespace {

// The sum of Taguchi's Eq. (5), term by term.
double direct(const std::vector<double>& row, std::size_t k) {
    std::complex<double> sum = 0;
    for (std::size_t x = 0; x < row.size(); ++x) {
        const double phase =
            -2 * std::numbers::pi * static_cast<double>(x * k) / static_cast<double>(row.size());
        sum += row[x] * std::polar(1.0, phase);
    }
    return std::norm(sum);
}

}  // namespace

BOOST_AUTO_TEST_CASE(equals_the_direct_sum) {
    for (const std::size_t n : {2, 3, 16, 63, 64}) {
        std::vector<double> row;
        for (std::size_t x = 0; x < n; ++x)
            row.push_back(std::sin(3.7 * static_cast<double>(x * x)));
        measure::LayerSpectrum spectrum(n);
        const auto power = spectrum(row);
        BOOST_TEST(power.size() == n / 2 + 1);
        for (std::size_t k = 0; k < power.size(); ++k) {
            // Powers are at most n^2; round-off of the direct sum.
            BOOST_TEST(std::abs(power[k] - direct(row, k)) < 1e-11);
        }
    }
}

BOOST_AUTO_TEST_CASE(plans_may_be_made_in_many_threads) {
    std::vector<std::jthread> threads;
    std::vector<double> sums(4, 0.0);
    for (std::size_t t = 0; t < sums.size(); ++t) {
        threads.emplace_back([t, &sums] {
            for (std::size_t i = 0; i < 200; ++i) {
                measure::LayerSpectrum spectrum(8 + i % 32);
                sums[t] += spectrum(std::vector<double>(8 + i % 32, 1.0))[1];
            }
        });
    }
    threads.clear();
    for (const double sum : sums)
        BOOST_TEST(sum < 1e-20);
}
