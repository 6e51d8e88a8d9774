// Damped chains of springs, whose eigenvalues are known mode by mode; what is no mode is refused.
#include "native/numerics/damped_modes.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace tt = boost::test_tools;
using namespace crossgrain::numerics;

namespace {

constexpr int n = 12;
constexpr double damping_ratio = 0.3;

/// Between two walls, springs of stiffness 900: w_j = 60 sin(pi j/(2 (n + 1))).
SparseMatrix chain() {
    SparseMatrix k(n, n);
    for (int i = 0; i < n; ++i) {
        k.insert(i, i) = 1800;
        if (i > 0) k.insert(i, i - 1) = -900;
        if (i + 1 < n) k.insert(i, i + 1) = -900;
    }
    return k;
}

std::complex<double> root_of(int j) {
    const double w = 60 * std::sin(std::numbers::pi * j / (2.0 * (n + 1)));
    const double c = damping_ratio / 10 * w * w;
    return -c / 2 + std::sqrt(std::complex<double>(c * c / 4 - w * w));
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_eigenvalue_of_a_damped_chain) {
    const SparseMatrix c = damping_ratio / 10 * chain();
    const auto all = damped_eigenvalues(chain(), c);
    BOOST_TEST(all.size() == 2 * n);
    for (int j = 1; j <= n; ++j) {
        const auto wanted = root_of(j);
        // Near critical damping two eigenvalues meet, which costs half of the digits.
        BOOST_TEST((all.array() - wanted).abs().minCoeff() < 1e-6 * std::abs(wanted));
        const auto mode = damped_mode(chain(), c, wanted);
        BOOST_TEST(mode.residual < 1e-12);
        // sin(pi j (i + 1)/(n + 1)) but for a factor: ratio of the first two.
        const double angle = std::numbers::pi * j / (n + 1);
        BOOST_TEST(std::abs(mode.vector(1) / mode.vector(0) -
                            std::sin(2 * angle) / std::sin(angle)) < 1e-8);
    }
}

BOOST_AUTO_TEST_CASE(what_is_no_eigenvalue_is_rejected) {
    const SparseMatrix c = damping_ratio / 10 * chain();
    BOOST_CHECK_THROW((void)damped_mode(chain(), c, root_of(1) * 1.01), std::runtime_error);
    BOOST_CHECK_THROW((void)damped_mode(chain(), c, {5, 0}), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(matrices_that_are_refused) {
    const auto refuse = [](const SparseMatrix& k, const SparseMatrix& c) {
        BOOST_CHECK_THROW((void)damped_eigenvalues(k, c), std::invalid_argument);
    };
    refuse(SparseMatrix(0, 0), SparseMatrix(0, 0));
    refuse(chain(), SparseMatrix(n + 1, n + 1));
    refuse(SparseMatrix(n, n + 1), SparseMatrix(n, n + 1));
    refuse(SparseMatrix(5001, 5001), SparseMatrix(5001, 5001));
    SparseMatrix infinite = chain();
    infinite.coeffRef(0, 0) = std::numeric_limits<double>::infinity();
    refuse(infinite, chain());
}
