// The judge of trends: decisions at known numbers, false alarms on noise, and what it must refuse.
#include "reference/compare/trend.hpp"

#include "native/base/random.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::compare;

namespace {

TrendPoint point(double at, double value, double error = 0.01) {
    return {.at = at, .value = value, .standard_error = error, .degrees_of_freedom = 50};
}

Outcome judged(Trend trend, const std::vector<TrendPoint>& points, double margin) {
    return judge_trend(trend, points, margin).outcome;
}

}  // namespace

BOOST_AUTO_TEST_CASE(constant_needs_every_pair_inside_the_margin) {
    const std::vector<TrendPoint> flat{point(0, 1.00), point(1, 1.02), point(2, 0.99)};
    BOOST_TEST((judged(Trend::constant, flat, 0.2) == Outcome::agree));
    BOOST_TEST((judged(Trend::constant, flat, 0.04) == Outcome::undecided));
    const std::vector<TrendPoint> bump{point(0, 1.00), point(1, 1.50), point(2, 1.01)};
    const auto answer = judge_trend(Trend::constant, bump, 0.2);
    BOOST_TEST((answer.outcome == Outcome::disagree));
    BOOST_TEST(answer.reason.find("between 0 and 1") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_change_is_judged_between_the_ends_of_the_parameter) {
    // Given out of order on purpose.
    const std::vector<TrendPoint> rising{point(2, 2.0), point(0, 1.0), point(1, 3.0)};
    BOOST_TEST((judged(Trend::increasing, rising, 0.5) == Outcome::agree));
    BOOST_TEST((judged(Trend::decreasing, rising, 0.5) == Outcome::disagree));
    BOOST_TEST((judged(Trend::increasing, rising, 1.5) == Outcome::disagree));
    BOOST_TEST((judged(Trend::increasing, {point(0, 1.0, 1.0), point(1, 2.0, 1.0)}, 0.5) ==
                Outcome::undecided));
}

BOOST_AUTO_TEST_CASE(noise_alone_is_rarely_called_a_change) {
    // Six points without a trend, their true spread 0: a margin of a tenth of the noise leaves
    // `disagree` to the corrected error rate of 5 %.
    constexpr std::uint64_t experiments = 2000;
    int alarms = 0;
    for (std::uint64_t e = 0; e < experiments; ++e) {
        std::vector<TrendPoint> points;
        for (std::uint64_t i = 0; i < 6; ++i) {
            const double noise = normal_pair(7, RandomStream::jitter, e * 6 + i)[0];
            points.push_back({.at = static_cast<double>(i),
                              .value = noise,
                              .standard_error = 1,
                              .degrees_of_freedom = 1e6});
        }
        alarms += judged(Trend::constant, points, 0.1) == Outcome::disagree;
    }
    BOOST_TEST(alarms < 0.05 * experiments);
}

BOOST_AUTO_TEST_CASE(without_degrees_of_freedom_nothing_is_decided) {
    std::vector<TrendPoint> points{point(0, 1), point(1, 9)};
    for (auto& p : points)
        p.degrees_of_freedom = 0;
    BOOST_TEST((judged(Trend::constant, points, 0.1) == Outcome::undecided));
    BOOST_TEST((judged(Trend::increasing, points, 0.1) == Outcome::undecided));
}

BOOST_AUTO_TEST_CASE(numbers_without_scatter_are_compared_as_they_are) {
    const std::vector<TrendPoint> exact{point(0, 1.0, 0), point(1, 1.1, 0)};
    BOOST_TEST((judged(Trend::constant, exact, 0.11) == Outcome::agree));
    BOOST_TEST((judged(Trend::constant, exact, 0.09) == Outcome::disagree));
}

BOOST_AUTO_TEST_CASE(questions_without_meaning_are_refused) {
    const std::vector<TrendPoint> one{point(0, 1)};
    BOOST_CHECK_THROW((void)judge_trend(Trend::constant, one, 0.1), std::invalid_argument);
    const std::vector<TrendPoint> two{point(0, 1), point(1, NAN)};
    BOOST_CHECK_THROW((void)judge_trend(Trend::constant, two, 0.1), std::invalid_argument);
    const std::vector<TrendPoint> fine{point(0, 1), point(1, 2)};
    BOOST_CHECK_THROW((void)judge_trend(Trend::increasing, fine, -1), std::invalid_argument);
    BOOST_CHECK_THROW((void)judge_trend(Trend::constant, fine, 0), std::invalid_argument);
}
