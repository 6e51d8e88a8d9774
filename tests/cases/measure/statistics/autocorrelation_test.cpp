// Autoregressive series of known correlation time: tau = (1 + phi)/(2 (1 - phi)).
#include "cases/measure/statistics/autocorrelation.hpp"

#include "reference/compare/student.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain::measure;
using crossgrain::compare::student_quantile;

namespace {

/// x_i = phi x_{i-1} + noise, with mean 0 and variance 1.
std::vector<double> autoregressive(double phi, std::size_t count, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    std::vector<double> series(count);
    double x = normal(random);
    for (double& value : series) {
        value = x;
        x = phi * x + std::sqrt(1 - phi * phi) * normal(random);
    }
    return series;
}

struct Found {
    double mean_time = 0, coverage = 0;
    int answered = 0;
};

Found over_many(double phi, std::size_t count, int trials, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Found found;
    int covered = 0;
    for (int i = 0; i < trials; ++i) {
        const auto answer = autocorrelated_mean(autoregressive(phi, count, random));
        if (!answer) continue;
        ++found.answered;
        found.mean_time += answer->time;
        const double half =
            student_quantile(0.975, answer->independent - 1) * answer->standard_error;
        covered += std::abs(answer->value) <= half ? 1 : 0;
    }
    found.mean_time /= found.answered;
    found.coverage = static_cast<double>(covered) / found.answered;
    return found;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_correlation_time_is_the_known_one) {
    for (const double phi : {0.0, 0.5, 0.9, -0.5}) {
        const double tau = (1 + phi) / (2 * (1 - phi));
        BOOST_TEST(over_many(phi, 4096, 200, 5).mean_time == tau, tt::tolerance(0.05));
    }
}

BOOST_AUTO_TEST_CASE(intervals_of_the_mean_hold_it_as_often_as_they_say) {
    for (const double phi : {0.0, 0.5, 0.9}) {
        const auto found = over_many(phi, 2048, 2000, 17);
        BOOST_TEST(found.coverage > 0.93, "phi = " << phi << ": " << found.coverage);
        BOOST_TEST(found.coverage < 0.97, "phi = " << phi << ": " << found.coverage);
    }
}

BOOST_AUTO_TEST_CASE(series_shorter_than_their_correlation_are_refused) {
    std::mt19937_64 random(2);
    BOOST_TEST(!autocorrelated_mean(autoregressive(0.5, 31, random)));
    int refused = 0;
    for (int i = 0; i < 50; ++i)
        refused += autocorrelated_mean(autoregressive(0.99, 256, random)) ? 0 : 1;
    BOOST_TEST(refused > 45);
}

BOOST_AUTO_TEST_CASE(a_constant_series_is_exact) {
    const auto answer = autocorrelated_mean(std::vector<double>(100, 2.5));
    BOOST_REQUIRE(answer.has_value());
    BOOST_TEST(answer->value == 2.5);
    BOOST_TEST(answer->standard_error == 0);
}
