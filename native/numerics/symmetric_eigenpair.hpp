// Largest eigenvalue of a sparse symmetric matrix, with the residual that says how far it is one.
#pragma once

#include <Eigen/SparseCore>

#include <cstddef>
#include <span>
#include <vector>

namespace crossgrain::numerics {

struct SymmetricEigenpair {
    double value = 0;
    std::vector<double> vector;  ///< shape (rows), of length 1
    double residual = 0;         ///< |A x - lambda x|/(|lambda| |x|)
};

/// When a pair counts as found.
struct EigenpairTolerance {
    double residual = 1e-8;            ///< largest residual that is accepted
    std::size_t most_restarts = 1000;  ///< of the Krylov space
};

/// |A x - lambda x|/(|lambda| |x|); for a symmetric A an eigenvalue lies within that relative
/// distance of lambda (Parlett, The Symmetric Eigenvalue Problem (1998), theorem 4.5.1). 0 for
/// A x = lambda x exactly, whatever lambda. Throws std::invalid_argument for shapes that do not
/// fit and for a vector of length 0.
[[nodiscard]] double eigenpair_residual(const Eigen::SparseMatrix<double>& a, double value,
                                        std::span<const double> vector);

/// The algebraically largest eigenvalue by the implicitly restarted Lanczos method (Spectra; dense
/// QR below 64 rows); the same bits in every call.
/// Throws std::invalid_argument for a matrix that is empty, not square, not symmetric to 1e-12 of
/// its largest element or not finite, and std::runtime_error if the residual stays above the
/// tolerance.
[[nodiscard]] SymmetricEigenpair largest_eigenpair(const Eigen::SparseMatrix<double>& a,
                                                   EigenpairTolerance tolerance = {});

}  // namespace crossgrain::numerics
