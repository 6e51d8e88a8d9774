// Eigenvalues of the equation of motion u'' = -K u - C u', with K and C symmetric:
//   (mu^2 + mu C + K) u = 0      (quadratic eigenvalue problem; Tisseur & Meerbergen, SIAM Review
//                                 43, 235 (2001))
// as those of the real matrix of twice the size with the blocks (0, w; -K/w, -C) for (w u, u'),
// w^2 the size of K, which puts both on one scale.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>

namespace crossgrain::numerics {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// All of them, shape (2 rows), by the dense QR algorithm: O(rows^3) operations, two seconds for
/// 480 rows. (Krylov spaces find the ends of a spectrum; what decides stability lies within.)
/// Throws std::invalid_argument for matrices that are empty, not square, not equally large, not
/// finite or of more than 5000 rows, and std::runtime_error if the algorithm does not converge.
[[nodiscard]] Eigen::VectorXcd damped_eigenvalues(const SparseMatrix& k, const SparseMatrix& c);

struct DampedMode {
    std::complex<double> eigenvalue;
    Eigen::VectorXcd vector;  ///< u, of length 1
    double residual = 0;      ///< |(mu^2 + mu C + K) u|/((|mu|^2 + |mu| |C| + |K|) |u|)
};

/// The mode whose eigenvalue is near `eigenvalue`, by inverse iteration with a sparse LU.
/// Throws std::runtime_error if the residual stays above `tolerance`: there is none.
[[nodiscard]] DampedMode damped_mode(const SparseMatrix& k, const SparseMatrix& c,
                                     std::complex<double> eigenvalue, double tolerance = 1e-10);

}  // namespace crossgrain::numerics
