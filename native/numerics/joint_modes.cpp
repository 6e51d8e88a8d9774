#include "native/numerics/joint_modes.hpp"

#include <Eigen/Eigenvalues>

#include <stdexcept>

namespace crossgrain::numerics {

std::optional<JointModes> joint_modes(const Eigen::SparseMatrix<double>& a,
                                      const Eigen::SparseMatrix<double>& b) {
    if (a.rows() == 0 || a.rows() != a.cols() || b.rows() != a.rows() || b.cols() != a.cols()) {
        throw std::invalid_argument("joint modes need two square matrices of the same size");
    }
    const Eigen::SparseMatrix<double> commutator = a * b - b * a;
    if (commutator.norm() > 1e-10 * a.norm() * b.norm()) return std::nullopt;
    const auto scale = [](double norm) { return norm > 0 ? 1 / norm : 0.0; };
    // Irrational, so that eigenvalues of the sum coincide only where both coincide.
    constexpr double t = 0.6180339887498949;
    const Eigen::MatrixXd sum =
        scale(a.norm()) * Eigen::MatrixXd(a) + t * scale(b.norm()) * Eigen::MatrixXd(b);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(sum);
    JointModes modes{.vectors = solver.eigenvectors()};
    const Eigen::MatrixXd image_a = a * modes.vectors, image_b = b * modes.vectors;
    modes.first = modes.vectors.cwiseProduct(image_a).colwise().sum();
    modes.second = modes.vectors.cwiseProduct(image_b).colwise().sum();
    return modes;
}

}  // namespace crossgrain::numerics
