#include "native/numerics/least_squares.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crossgrain::numerics {
namespace {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void check(std::span<const double> design, std::size_t columns, std::span<const double> y,
           std::span<const double> errors) {
    const auto finite = [](double value) { return std::isfinite(value); };
    const bool shapes_fit = columns >= 1 && y.size() >= columns && errors.size() == y.size() &&
                            design.size() == y.size() * columns;
    if (!shapes_fit) {
        throw std::invalid_argument(
            fmt::format("least squares need a design of rows x columns and as many y and errors as "
                        "rows, rows >= columns >= 1: got {} numbers, {} columns, {} y, {} errors",
                        design.size(), columns, y.size(), errors.size()));
    }
    if (!std::ranges::all_of(design, finite) || !std::ranges::all_of(y, finite) ||
        !std::ranges::all_of(errors, [&](double e) { return finite(e) && e > 0; })) {
        throw std::invalid_argument("least squares need finite numbers and errors > 0");
    }
}

}  // namespace

LeastSquaresFit fit_linear(std::span<const double> design, std::size_t columns,
                           std::span<const double> y, std::span<const double> standard_errors) {
    check(design, columns, y, standard_errors);
    const auto rows = static_cast<Eigen::Index>(y.size());
    const auto width = static_cast<Eigen::Index>(columns);
    const Eigen::Map<const Eigen::VectorXd> errors(standard_errors.data(), rows);
    const Eigen::MatrixXd a = errors.cwiseInverse().asDiagonal() *
                              Eigen::Map<const RowMajorMatrix>(design.data(), rows, width);
    const Eigen::VectorXd b =
        Eigen::Map<const Eigen::VectorXd>(y.data(), rows).cwiseQuotient(errors);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
    if (qr.rank() < width) {
        throw std::invalid_argument(fmt::format(
            "least squares need linearly independent columns: rank {} of {}", qr.rank(), columns));
    }
    const Eigen::VectorXd c = qr.solve(b);
    const Eigen::MatrixXd r_inverse = qr.matrixR()
                                          .topLeftCorner(width, width)
                                          .triangularView<Eigen::Upper>()
                                          .solve(Eigen::MatrixXd::Identity(width, width));
    const Eigen::MatrixXd root = qr.colsPermutation() * r_inverse;
    const Eigen::MatrixXd covariance = root * root.transpose();
    return {.coefficients = {c.begin(), c.end()},
            .covariance = {covariance.data(), covariance.data() + covariance.size()},
            .chi_squared = (b - a * c).squaredNorm(),
            .degrees_of_freedom = static_cast<double>(rows - width)};
}

}  // namespace crossgrain::numerics
