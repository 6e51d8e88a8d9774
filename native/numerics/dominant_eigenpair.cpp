#include "native/numerics/dominant_eigenpair.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Spectra/GenEigsSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace crossgrain::numerics {
namespace {

/// M^power as Spectra wants to see it.
class PowerOfMap {
  public:
    using Scalar = double;

    PowerOfMap(Eigen::Index size, const LinearMap& map, int power)
        : size_(size), map_(map), power_(power) {}

    [[nodiscard]] Eigen::Index rows() const { return size_; }
    [[nodiscard]] Eigen::Index cols() const { return size_; }
    void perform_op(const double* in, double* out) const {
        Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(in, size_), y(size_);
        for (int i = 0; i < power_; ++i) {
            map_(x, y);
            std::swap(x, y);
        }
        if (!x.allFinite()) throw std::runtime_error("the map gives numbers that are not finite");
        Eigen::Map<Eigen::VectorXd>(out, size_) = x;
    }

  private:
    Eigen::Index size_;
    const LinearMap& map_;
    int power_;
};

Eigen::VectorXcd image_of(const LinearMap& map, const Eigen::VectorXcd& x) {
    const Eigen::VectorXd real = x.real(), imaginary = x.imag();
    Eigen::VectorXd real_image(x.size()), imaginary_image(x.size());
    map(real, real_image);
    map(imaginary, imaginary_image);
    Eigen::VectorXcd image(x.size());
    image.real() = real_image;
    image.imag() = imaginary_image;
    return image;
}

/// Of the eigenpairs of M within the space of the columns the one of largest modulus.
DominantEigenpair largest_in(const LinearMap& map, const Eigen::MatrixXcd& space) {
    const Eigen::HouseholderQR<Eigen::MatrixXcd> qr(space);
    const Eigen::MatrixXcd basis =
        qr.householderQ() * Eigen::MatrixXcd::Identity(space.rows(), space.cols());
    Eigen::MatrixXcd image(space.rows(), space.cols());
    for (Eigen::Index j = 0; j < space.cols(); ++j)
        image.col(j) = image_of(map, basis.col(j));
    const Eigen::ComplexEigenSolver<Eigen::MatrixXcd> ritz(basis.adjoint() * image);
    Eigen::Index largest = 0;
    ritz.eigenvalues().cwiseAbs().maxCoeff(&largest);
    return {.value = ritz.eigenvalues()(largest),
            .vector = (basis * ritz.eigenvectors().col(largest)).normalized()};
}

}  // namespace

double eigenpair_residual(const LinearMap& map, std::complex<double> value,
                          const Eigen::VectorXcd& vector) {
    return (image_of(map, vector) - value * vector).norm() / (std::abs(value) * vector.norm());
}

DominantEigenpair dominant_eigenpair(std::size_t size, const LinearMap& map,
                                     const DominantSearch& search) {
    constexpr Eigen::Index smallest = 8, wanted = 4, krylov = 48;
    const auto n = static_cast<Eigen::Index>(size);
    if (n < smallest || search.power < 1 || search.power % 2 == 0) {
        throw std::invalid_argument(
            fmt::format("a dominant eigenpair needs {} dimensions or more and an odd power, not "
                        "{} and {}",
                        smallest, size, search.power));
    }
    PowerOfMap power(n, map, search.power);
    Spectra::GenEigsSolver<PowerOfMap> solver(power, wanted, std::min(krylov, n));
    solver.init();
    const auto found =
        solver.compute(Spectra::SortRule::LargestMagn,
                       static_cast<Eigen::Index>(search.most_restarts), search.residual / 100);
    if (found == 0) {
        throw std::runtime_error(
            fmt::format("no dominant eigenvalue has converged within {} restarts of a Krylov "
                        "space of power {}",
                        search.most_restarts, search.power));
    }
    DominantEigenpair pair = largest_in(map, solver.eigenvectors());
    pair.residual = eigenpair_residual(map, pair.value, pair.vector);
    if (!(pair.residual <= search.residual)) {
        throw std::runtime_error(fmt::format(
            "the dominant eigenvalue has not converged: modulus {:.9g} with a residual of {:.3g}, "
            "{:.3g} accepted",
            std::abs(pair.value), pair.residual, search.residual));
    }
    return pair;
}

}  // namespace crossgrain::numerics
