// The jackknife of a mean is its standard error, exactly.
#include "native/numerics/jackknife.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain;

BOOST_AUTO_TEST_CASE(error_of_a_mean) {
    const std::vector<double> data{1, 4, 2, 8, 5, 7};
    double sum = 0, squares = 0;
    for (const double value : data)
        sum += value;
    for (const double value : data)
        squares += std::pow(value - sum / 6, 2);
    std::vector<double> means;
    for (const double value : data)
        means.push_back((sum - value) / 5);
    BOOST_TEST(numerics::jackknife_error(means) == std::sqrt(squares / 5 / 6),
               tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(no_scatter_no_error) {
    BOOST_TEST(numerics::jackknife_error(std::vector<double>{0.1, 0.1, 0.1}) == 0);
}
