// Resampling: the error of a mean is known, and a statistic that is mostly missing has none.
#include "native/numerics/bootstrap.hpp"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using crossgrain::numerics::bootstrap_error;

BOOST_AUTO_TEST_CASE(the_error_of_a_mean) {
    const std::array data{1.0, 4.0, 2.0, 8.0, 5.0, 7.0};
    std::mt19937_64 random(3);
    const auto error = bootstrap_error(20000, [&](std::size_t) -> std::optional<double> {
        double sum = 0;
        for (std::size_t i = 0; i < data.size(); ++i)
            sum += data[random() % data.size()];
        return sum / 6;
    });
    // Variance of the data 37.5/6, of a mean of six of them a sixth; 20000 resamples know a
    // standard deviation to 0.5 %.
    BOOST_TEST(error.value() == std::sqrt(37.5 / 36), tt::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(resamples_come_in_ascending_order) {
    std::vector<std::size_t> seen;
    const auto error = bootstrap_error(100, [&](std::size_t i) -> std::optional<double> {
        seen.push_back(i);
        return static_cast<double>(i);
    });
    for (std::size_t i = 0; i < seen.size(); ++i)
        BOOST_TEST(seen[i] == i);
    // Variance of 0..99 with n - 1: 100 101/12.
    BOOST_TEST(error.value() == std::sqrt(100 * 101 / 12.0), tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_statistic_that_is_mostly_missing_has_no_error) {
    const auto with = [](std::size_t missing) {
        return bootstrap_error(100, [missing](std::size_t i) -> std::optional<double> {
            if (i < missing) return std::nullopt;
            return 1.0;
        });
    };
    BOOST_TEST(with(10).has_value());
    BOOST_TEST(!with(11).has_value());
    BOOST_CHECK_THROW((void)bootstrap_error(99, [](std::size_t) { return std::optional(1.0); }),
                      std::invalid_argument);
}
