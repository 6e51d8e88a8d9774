// Exponents of synthetic power laws measured with replicas: the interval must hold the exponent put
// in as often as it says, and a law that bends must show in its windows.
#include "reference/compare/bootstrap.hpp"

#include "reference/compare/student.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain::compare;

namespace {

constexpr double exponent = -1.4;

/// 3 x^exponent at x = 1, 2, 4, ..., each replica off by a relative `scatter`.
std::vector<ReplicatedPoint> power_law(double scatter, std::size_t replicas, std::uint64_t seed,
                                       std::size_t count = 6) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<ReplicatedPoint> points;
    for (std::size_t i = 0; i < count; ++i) {
        ReplicatedPoint point{.x = std::pow(2.0, static_cast<double>(i))};
        for (std::size_t r = 0; r < replicas; ++r)
            point.y.push_back(3 * std::pow(point.x, exponent) * (1 + scatter * normal(random)));
        points.push_back(std::move(point));
    }
    return points;
}

std::vector<SweepPoint> means(const std::vector<ReplicatedPoint>& points) {
    std::vector<SweepPoint> result;
    for (const auto& p : points) {
        double sum = 0;
        for (const double y : p.y)
            sum += y;
        result.push_back({.x = p.x, .y = sum / static_cast<double>(p.y.size())});
    }
    return result;
}

std::optional<double> fitted(std::span<const SweepPoint> points) {
    const auto fit = fit_exponent(points);
    return fit ? std::optional(fit->value) : std::nullopt;
}

std::optional<double> never(std::span<const SweepPoint> /*points*/) {
    return std::nullopt;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_error_is_that_of_linear_propagation_where_it_is_linear) {
    // Six points, ln x in steps of ln 2: the slope's error is s/sqrt(17.5)/ln 2, s of each point.
    const auto points = power_law(0.02, 400, 1);
    const double expected = 0.02 / std::sqrt(400.0) / std::sqrt(17.5) / std::log(2.0);
    BOOST_TEST(bootstrap_error(points, fitted, 2000).value() == expected, tt::tolerance(0.1));
    BOOST_TEST(bootstrap_error(power_law(0, 8, 1), fitted).value() < 1e-12);
}

// 400 synthetic sweeps of eight replicas: 95 % +- 2.1 % (two standard deviations of the count).
// Six points with seven degrees of freedom each are worth about 42.
BOOST_AUTO_TEST_CASE(the_interval_covers_the_exponent) {
    constexpr int trials = 400;
    int covered = 0;
    for (int i = 0; i < trials; ++i) {
        const auto points = power_law(0.1, 8, static_cast<std::uint64_t>(100 + i));
        const double half =
            student_quantile(0.975, 42) * bootstrap_error(points, fitted, 200).value();
        covered += std::abs(fitted(means(points)).value() - exponent) <= half ? 1 : 0;
    }
    BOOST_TEST(covered >= 0.92 * trials);
    BOOST_TEST(covered <= 0.975 * trials);
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_error) {
    const auto points = power_law(0.1, 6, 5);
    BOOST_TEST(bootstrap_error(points, fitted, 200, 3).value() ==
               bootstrap_error(points, fitted, 200, 3).value());
}

BOOST_AUTO_TEST_CASE(windows_show_a_law_that_bends) {
    auto points = means(power_law(0, 1, 1));
    BOOST_TEST(systematic_over_windows(points, fitted).value() < 1e-12);
    points.back().y *= 2;
    const double without = fitted(std::span(points).first(5)).value();
    BOOST_TEST(without == exponent, tt::tolerance(1e-12));
    BOOST_TEST(systematic_over_windows(points, fitted).value() >=
               std::abs(fitted(points).value() - exponent) / 2);
}

BOOST_AUTO_TEST_CASE(too_little_has_no_error) {
    BOOST_TEST(!bootstrap_error(power_law(0.1, 3, 1), fitted));
    BOOST_TEST(!bootstrap_error({}, fitted));
    BOOST_TEST(!bootstrap_error(power_law(0.1, 8, 1), never));
    BOOST_TEST(!systematic_over_windows(means(power_law(0, 1, 1, 3)), fitted));
    BOOST_TEST(!systematic_over_windows(means(power_law(0, 1, 1)), never));
    BOOST_CHECK_THROW((void)bootstrap_error(power_law(0.1, 8, 1), fitted, 10),
                      std::invalid_argument);
}
