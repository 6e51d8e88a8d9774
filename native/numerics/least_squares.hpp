// Weighted linear least squares, y_i = sum_j a_ij c_j with standard errors s_i of y_i:
//   minimise chi^2 = sum_i ((y_i - sum_j a_ij c_j)/s_i)^2
// by Householder's QR of the weighted design matrix, A = Q R P^T with columns pivoted; the
// covariance of the coefficients is P R^-1 R^-T P^T (Golub & Van Loan, Matrix Computations, 4th ed.
// (2013), sections 5.3 and 5.5). The normal equations, which square the condition, are not formed.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace crossgrain::numerics {

struct LeastSquaresFit {
    std::vector<double> coefficients;  ///< shape (columns)
    std::vector<double> covariance;    ///< shape (columns, columns), row by row
    double chi_squared = 0;
    double degrees_of_freedom = 0;  ///< rows - columns

    [[nodiscard]] double covariance_of(std::size_t i, std::size_t j) const {
        return covariance[i * coefficients.size() + j];
    }
};

/// `design`: shape (rows, columns), row by row; `y` and `standard_errors`: shape (rows). The
/// covariance follows from the standard errors alone.
/// Throws std::invalid_argument unless the shapes fit, rows >= columns >= 1, all numbers are
/// finite, all errors > 0 and the columns linearly independent.
[[nodiscard]] LeastSquaresFit fit_linear(std::span<const double> design, std::size_t columns,
                                         std::span<const double> y,
                                         std::span<const double> standard_errors);

}  // namespace crossgrain::numerics
