#include "native/numerics/damped_modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseLU>
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace crossgrain::numerics {
namespace {

using Complex = std::complex<double>;
using ComplexMatrix = Eigen::SparseMatrix<Complex>;

void check(const SparseMatrix& k, const SparseMatrix& c) {
    constexpr Eigen::Index most_rows = 5000;
    if (k.rows() == 0 || k.rows() != k.cols() || c.rows() != k.rows() || c.cols() != k.cols()) {
        throw std::invalid_argument("damped modes need two square matrices of the same size");
    }
    if (k.rows() > most_rows) {
        throw std::invalid_argument(fmt::format(
            "damped modes of {} rows would take hours: {} at most", k.rows(), most_rows));
    }
    if (!std::isfinite(k.norm()) || !std::isfinite(c.norm())) {
        throw std::invalid_argument("damped modes need matrices of finite numbers");
    }
}

/// mu^2 + mu C + K.
ComplexMatrix at(const SparseMatrix& k, const SparseMatrix& c, Complex mu) {
    ComplexMatrix one(k.rows(), k.rows());
    one.setIdentity();
    return mu * mu * one + mu * c.cast<Complex>() + k.cast<Complex>();
}

}  // namespace

Eigen::VectorXcd damped_eigenvalues(const SparseMatrix& k, const SparseMatrix& c) {
    check(k, c);
    const Eigen::Index n = k.rows();
    const double size = std::sqrt(k.norm() / std::sqrt(static_cast<double>(n)));
    const double w = size > 0 ? size : 1;
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    companion.topRightCorner(n, n).diagonal().setConstant(w);
    companion.bottomLeftCorner(n, n) = Eigen::MatrixXd(k) / -w;
    companion.bottomRightCorner(n, n) = -Eigen::MatrixXd(c);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(companion, false);
    if (solver.info() != Eigen::Success) {
        throw std::runtime_error("the eigenvalues of the damped modes have not converged");
    }
    return solver.eigenvalues();
}

DampedMode damped_mode(const SparseMatrix& k, const SparseMatrix& c, Complex eigenvalue,
                       double tolerance) {
    check(k, c);
    constexpr int iterations = 3;
    const double size = std::norm(eigenvalue) + std::abs(eigenvalue) * c.norm() + k.norm();
    // Off the eigenvalue by little, so that the matrix is not singular to the last bit.
    const Eigen::SparseLU<ComplexMatrix> lu(at(k, c, eigenvalue * (1 + 1e-12)));
    Eigen::VectorXcd u(k.rows());
    // Any vector that is not an eigenvector; the same on every machine.
    for (Eigen::Index i = 0; i < u.size(); ++i)
        u(i) = std::sin(1.0 + 0.7 * static_cast<double>(i * i % 1009));
    for (int i = 0; i < iterations && lu.info() == Eigen::Success; ++i) {
        const Eigen::VectorXcd next = lu.solve(u);
        u = next.normalized();
    }
    const double residual = (at(k, c, eigenvalue) * u).norm() / (size * u.norm());
    if (!(residual <= tolerance)) {
        throw std::runtime_error(fmt::format(
            "no damped mode has the eigenvalue {:.9g} {:+.9g}i: the residual is {:.3g}, "
            "{:.3g} accepted",
            eigenvalue.real(), eigenvalue.imag(), residual, tolerance));
    }
    return {eigenvalue, u, residual};
}

}  // namespace crossgrain::numerics
