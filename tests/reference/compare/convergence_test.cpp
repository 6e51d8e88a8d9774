// Order and limit from ladders of known order and limit.
#include "reference/compare/convergence.hpp"

#include "native/base/random.hpp"
#include "reference/compare/student.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;
using namespace crossgrain::compare;

namespace {

// Mean limit + slope dt, rms C dt^p with relative errors, noise drawn from (seed, ladder).
std::vector<Rung> ladder(double limit, double order, double relative_error, std::uint64_t which) {
    std::vector<Rung> rungs;
    std::uint64_t i = 8 * which;
    for (const double dt : {1e-2, 5e-3, 2e-3, 1e-3, 5e-4}) {
        const auto noise = normal_pair(3, RandomStream::jitter, i++);
        const double rms = 0.2 * std::pow(dt, order);
        const double mean_error = 1e-5;
        rungs.push_back({.dt = dt,
                         .mean_error = limit + 0.3 * dt + mean_error * noise[0],
                         .mean_standard_error = mean_error,
                         .rms_error = rms * (1 + relative_error * noise[1]),
                         .rms_standard_error = relative_error * rms});
    }
    return rungs;
}

}  // namespace

BOOST_AUTO_TEST_CASE(finds_an_exact_order_and_limit) {
    auto rungs = ladder(2e-3, 1.0, 0.0, 0);
    for (Rung& r : rungs) {
        r.mean_error = 2e-3 - 0.4 * r.dt;
        r.mean_standard_error = 0;
    }
    const auto found = convergence(rungs);
    // A few roundings of logarithms.
    BOOST_TEST(found.order.value == 1.0, tt::tolerance(1e-12));
    BOOST_TEST(found.order.standard_error < 1e-12);
    BOOST_TEST(found.limit.value == 2e-3, tt::tolerance(1e-12));
    BOOST_TEST(found.limit.degrees_of_freedom == 3);
}

BOOST_AUTO_TEST_CASE(stated_errors_cover_the_truth) {
    constexpr std::uint64_t ladders = 4000;
    double order_covered = 0, limit_covered = 0;
    for (std::uint64_t n = 0; n < ladders; ++n) {
        const auto found = convergence(ladder(0.0, 1.5, 0.05, n));
        const auto covers = [](const Estimate& estimate, double truth) {
            const double t = student_quantile(0.975, estimate.degrees_of_freedom);
            return std::abs(estimate.value - truth) < t * estimate.standard_error;
        };
        order_covered += covers(found.order, 1.5) ? 1.0 / ladders : 0;
        limit_covered += covers(found.limit, 0.0) ? 1.0 / ladders : 0;
    }
    BOOST_TEST_MESSAGE("95 % intervals cover order " << order_covered << ", limit "
                                                     << limit_covered);
    // Never less than stated; the widening makes the intervals conservative.
    BOOST_TEST(order_covered > 0.945);
    BOOST_TEST(limit_covered > 0.945);
}

BOOST_AUTO_TEST_CASE(tells_a_wrong_order_and_a_wrong_limit) {
    const auto second_order = convergence(ladder(0.0, 2.0, 0.05, 1));
    BOOST_TEST(second_order.order.value - 1.0 > 5 * second_order.order.standard_error);
    const auto biased = convergence(ladder(1e-3, 1.0, 0.05, 2));
    BOOST_TEST(biased.limit.value > 5 * biased.limit.standard_error);
}

BOOST_AUTO_TEST_CASE(points_off_the_line_widen_the_error) {
    auto rungs = ladder(0.0, 1.0, 0.001, 3);
    const double before = convergence(rungs).order.standard_error;
    rungs[2].rms_error *= 1.5;
    BOOST_TEST(convergence(rungs).order.standard_error > 20 * before);
}

BOOST_AUTO_TEST_CASE(refuses_ladders_that_cannot_tell) {
    const auto good = ladder(0.0, 1.0, 0.05, 4);
    const auto refuse = [](const std::vector<Rung>& rungs) {
        BOOST_CHECK_THROW(static_cast<void>(convergence(rungs)), std::invalid_argument);
    };
    refuse({});
    refuse({good[0], good[1]});
    refuse({good[0], good[1], good[0], good[1]});
    auto bad = good;
    bad[0].rms_error = 0;
    refuse(bad);
    bad = good;
    bad[1].dt = -1;
    refuse(bad);
    bad = good;
    bad[1].mean_error = std::nan("");
    refuse(bad);
    bad = good;
    bad[3].mean_standard_error = 0;
    refuse(bad);
}
