// Common eigenvectors of matrices that commute, also where one of them cannot tell modes apart.
#include "native/numerics/joint_modes.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <stdexcept>

using namespace crossgrain::numerics;
using Matrix = Eigen::SparseMatrix<double>;

namespace {

/// A ring of n: its modes come in pairs of equal eigenvalue.
Matrix ring(int n, int reach) {
    Matrix a(n, n);
    for (int i = 0; i < n; ++i) {
        a.coeffRef(i, i) += 2;
        a.coeffRef(i, (i + reach) % n) -= 1;
        a.coeffRef(i, (i + n - reach) % n) -= 1;
    }
    return a;
}

}  // namespace

BOOST_AUTO_TEST_CASE(rings_with_springs_to_different_neighbours) {
    const Matrix a = ring(12, 1), b = ring(12, 5);
    const auto modes = joint_modes(a, b);
    BOOST_TEST_REQUIRE(modes.has_value());
    BOOST_TEST((a * modes->vectors - modes->vectors * modes->first.asDiagonal()).norm() < 1e-12);
    BOOST_TEST((b * modes->vectors - modes->vectors * modes->second.asDiagonal()).norm() < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_matrix_of_zeros_commutes_with_all) {
    const auto modes = joint_modes(ring(6, 1), Matrix(6, 6));
    BOOST_TEST_REQUIRE(modes.has_value());
    BOOST_TEST(std::abs(modes->first.maxCoeff() - 4) < 1e-12);
    BOOST_TEST(modes->second.norm() == 0);
}

BOOST_AUTO_TEST_CASE(matrices_that_do_not_commute_have_none) {
    Matrix pinned = ring(12, 1);
    pinned.coeffRef(3, 3) += 1e-6;
    BOOST_TEST(!joint_modes(pinned, ring(12, 1)).has_value());
    BOOST_CHECK_THROW((void)joint_modes(ring(4, 1), ring(5, 1)), std::invalid_argument);
    BOOST_CHECK_THROW((void)joint_modes(Matrix(0, 0), Matrix(0, 0)), std::invalid_argument);
}
