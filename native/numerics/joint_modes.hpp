// Common eigenvectors of two symmetric matrices that commute.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <optional>

namespace crossgrain::numerics {

struct JointModes {
    Eigen::VectorXd first, second;  ///< eigenvalues of A and of B, shape (modes)
    Eigen::MatrixXd vectors;        ///< shape (rows, modes), columns of length 1
};

/// Modes u_i with A u_i = a_i u_i and B u_i = b_i u_i, from the eigenvectors of A/|A| + t B/|B|
/// with a t that tells apart what A alone does not. Dense: O(rows^3) operations, some seconds for
/// 1000 rows. Nothing if |A B - B A| > 1e-10 |A| |B| (Frobenius' norm).
/// Throws std::invalid_argument for matrices that are empty, not square or not equally large.
[[nodiscard]] std::optional<JointModes> joint_modes(const Eigen::SparseMatrix<double>& a,
                                                    const Eigen::SparseMatrix<double>& b);

}  // namespace crossgrain::numerics
