// Straight line through points, y = a + b x, by weighted least squares
// (Bevington & Robinson, Data Reduction and Error Analysis, 3rd ed. (2003), Eqs. 6.12 and 6.23).
// x is taken about its weighted mean, which makes the two columns of the design orthogonal: the QR
// of least_squares.hpp by Gram and Schmidt, without a matrix.
#pragma once

#include <cstddef>
#include <span>

namespace crossgrain::numerics {

/// A line whose errors nobody asks for.
struct Line {
    double intercept = 0, slope = 0;
    [[nodiscard]] double at(double x) const { return intercept + slope * x; }
};

struct LineFit {
    double intercept = 0, slope = 0;
    double intercept_variance = 0, slope_variance = 0, covariance = 0;
    double chi_squared = 0;         ///< weighted; sum of squared residuals for equal weights
    double degrees_of_freedom = 0;  ///< points - 2

    [[nodiscard]] double intercept_error() const;
    [[nodiscard]] double slope_error() const;
    [[nodiscard]] double at(double x) const { return intercept + slope * x; }
    /// Standard error of at(x), with the covariance.
    [[nodiscard]] double error_at(double x) const;
    /// Multiplies variances and covariance, e.g. by chi_squared/degrees_of_freedom.
    void scale_covariance(double factor);
};

/// Known standard errors of y: the covariance follows from them alone.
/// Throws std::invalid_argument unless the spans are equally long (>= 2), all numbers finite, all
/// errors > 0 and the x not all the same.
[[nodiscard]] LineFit fit_line(std::span<const double> x, std::span<const double> y,
                               std::span<const double> standard_errors);

/// Unknown, equal errors: they are estimated from the residuals, so that three points are needed.
[[nodiscard]] LineFit fit_line(std::span<const double> x, std::span<const double> y);

/// All points weighing the same, without errors: two points are enough. Throws like the others.
[[nodiscard]] Line line_through(std::span<const double> x, std::span<const double> y);

/// Standard error of the slope of line_through(x, y) that the standard errors of y make.
/// Throws std::invalid_argument unless the spans are equally long and the x not all the same.
[[nodiscard]] double propagated_slope_error(std::span<const double> x,
                                            std::span<const double> standard_errors);

}  // namespace crossgrain::numerics
