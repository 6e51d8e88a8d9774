// The largest eigenvalue of chains of springs, which are known; pairs and matrices to be refused.
#include "native/numerics/symmetric_eigenpair.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace tt = boost::test_tools;
using namespace crossgrain::numerics;
using Matrix = Eigen::SparseMatrix<double>;

namespace {

/// n masses between two walls, springs of stiffness 1: lambda_j = 4 sin^2(pi j/(2 (n + 1))).
Matrix chain(int n) {
    Matrix a(n, n);
    for (int i = 0; i < n; ++i) {
        a.insert(i, i) = 2;
        if (i > 0) a.insert(i, i - 1) = -1;
        if (i + 1 < n) a.insert(i, i + 1) = -1;
    }
    return a;
}

}  // namespace

BOOST_AUTO_TEST_CASE(chains_of_springs) {
    for (const int n : {1, 2, 10, 63, 64, 300, 1000}) {
        const auto pair = largest_eigenpair(chain(n));
        const double root = 2 * std::sin(std::numbers::pi * n / (2.0 * (n + 1)));
        BOOST_TEST(pair.value == root * root, tt::tolerance(1e-10));
        BOOST_TEST(pair.residual <= 1e-8);
        BOOST_TEST(pair.residual == eigenpair_residual(chain(n), pair.value, pair.vector));
    }
}

BOOST_AUTO_TEST_CASE(largest_means_algebraically) {
    Matrix a(2, 2);
    a.insert(0, 0) = -5;
    a.insert(1, 1) = 1;
    BOOST_TEST(largest_eigenpair(a).value == 1, tt::tolerance(1e-14));
    BOOST_TEST(largest_eigenpair(Matrix(100, 100)).value == 0);
}

BOOST_AUTO_TEST_CASE(a_pair_that_has_not_converged_is_rejected) {
    // Neighbouring eigenvalues of the long chain differ by 3e-6: one Krylov space is not enough.
    BOOST_CHECK_THROW((void)largest_eigenpair(chain(1000), {.most_restarts = 1}),
                      std::runtime_error);
    // A residual tells the quotient's digits from the vector's: of the alternating vector it is
    // large, though its quotient is near the eigenvalue.
    std::vector<double> alternating(1000);
    for (std::size_t i = 0; i < alternating.size(); ++i)
        alternating[i] = i % 2 == 0 ? 1 : -1;
    const double quotient = 4 - 2.0 / 1000;
    BOOST_TEST(eigenpair_residual(chain(1000), quotient, alternating) > 1e-3);
    BOOST_CHECK_THROW((void)eigenpair_residual(chain(3), 1, std::vector<double>(3, 0.0)),
                      std::invalid_argument);
    BOOST_CHECK_THROW((void)eigenpair_residual(chain(3), 1, std::vector<double>(2, 1.0)),
                      std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(matrices_that_are_refused) {
    const auto refuse = [](const Matrix& a) {
        BOOST_CHECK_THROW((void)largest_eigenpair(a), std::invalid_argument);
    };
    refuse(Matrix(0, 0));
    refuse(Matrix(3, 4));
    Matrix skewed = chain(5);
    skewed.coeffRef(0, 1) = -1.1;
    refuse(skewed);
    Matrix infinite = chain(5);
    infinite.coeffRef(2, 2) = std::numeric_limits<double>::infinity();
    refuse(infinite);
}
