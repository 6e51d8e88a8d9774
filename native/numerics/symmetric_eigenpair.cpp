#include "native/numerics/symmetric_eigenpair.hpp"

#include <Eigen/Eigenvalues>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymEigsSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::numerics {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

void check(const Matrix& a) {
    if (a.rows() == 0 || a.rows() != a.cols()) {
        throw std::invalid_argument(
            fmt::format("an eigenvalue needs a square matrix of one row or more, not {} x {}",
                        a.rows(), a.cols()));
    }
    double largest = 0;
    bool finite = true;
    for (Eigen::Index j = 0; j < a.outerSize(); ++j) {
        for (Matrix::InnerIterator it(a, j); it; ++it) {
            finite = finite && std::isfinite(it.value());
            largest = std::max(largest, std::abs(it.value()));
        }
    }
    if (!finite) throw std::invalid_argument("an eigenvalue needs a matrix of finite numbers");
    const Matrix skew = a - Matrix(a.transpose());
    double asymmetry = 0;
    for (Eigen::Index j = 0; j < skew.outerSize(); ++j)
        for (Matrix::InnerIterator it(skew, j); it; ++it)
            asymmetry = std::max(asymmetry, std::abs(it.value()));
    if (asymmetry > 1e-12 * largest) {
        throw std::invalid_argument(
            fmt::format("the matrix is not symmetric: elements differ by {:.3g} of {:.3g}",
                        asymmetry, largest));
    }
}

struct Found {
    double value = 0;
    Eigen::VectorXd vector;
};

Found by_dense_decomposition(const Matrix& a) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{Eigen::MatrixXd(a)};
    const Eigen::Index last = a.rows() - 1;
    return {solver.eigenvalues()(last), solver.eigenvectors().col(last)};
}

Found by_lanczos(const Matrix& a, EigenpairTolerance tolerance) {
    constexpr Eigen::Index krylov = 40;
    Spectra::SparseSymMatProd<double> product(a);
    Spectra::SymEigsSolver<Spectra::SparseSymMatProd<double>> solver(product, 1, krylov);
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge,
                   static_cast<Eigen::Index>(tolerance.most_restarts), tolerance.residual / 10);
    if (solver.info() != Spectra::CompInfo::Successful) {
        throw std::runtime_error(
            fmt::format("the largest eigenvalue has not converged within {} restarts",
                        tolerance.most_restarts));
    }
    return {solver.eigenvalues()(0), solver.eigenvectors().col(0)};
}

}  // namespace

double eigenpair_residual(const Matrix& a, double value, std::span<const double> vector) {
    const Eigen::Map<const Eigen::VectorXd> x(vector.data(),
                                              static_cast<Eigen::Index>(vector.size()));
    if (a.rows() != a.cols() || a.rows() != x.size() || !(x.norm() > 0)) {
        throw std::invalid_argument("the residual of an eigenpair needs a square matrix and a "
                                    "vector of as many rows that is not zero");
    }
    const double off = (a * x - value * x).norm();
    return off == 0 ? 0 : off / (std::abs(value) * x.norm());
}

SymmetricEigenpair largest_eigenpair(const Matrix& a, EigenpairTolerance tolerance) {
    constexpr Eigen::Index fewest_for_lanczos = 64;
    check(a);
    const Found found = a.rows() < fewest_for_lanczos || a.nonZeros() == 0
                            ? by_dense_decomposition(a)
                            : by_lanczos(a, tolerance);
    SymmetricEigenpair pair{.value = found.value,
                            .vector = {found.vector.begin(), found.vector.end()}};
    pair.residual = eigenpair_residual(a, pair.value, pair.vector);
    if (!(pair.residual <= tolerance.residual)) {
        throw std::runtime_error(
            fmt::format("the largest eigenvalue has not converged: {:.6g} with a residual of "
                        "{:.3g}, {:.3g} accepted",
                        pair.value, pair.residual, tolerance.residual));
    }
    return pair;
}

}  // namespace crossgrain::numerics
