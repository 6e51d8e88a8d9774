// Non-linear least squares, sum_i r_i(p)^2, by Levenberg's and Marquardt's damped Gauss-Newton
// steps (Marquardt, J. Soc. Indust. Appl. Math. 11, 431 (1963)):
//   minimise |J d + r|^2 + lambda |D d|^2,  D_jj = |J_j|,
// each step a linear least-squares problem of its own (least_squares.hpp; More, Lecture Notes in
// Mathematics 630, 105 (1978)). lambda falls tenfold after a step that lowers the sum and grows
// tenfold after one that does not. Parameters keep within bounds: a step is cut off there, and a
// parameter on a bound that the step would leave is held.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace crossgrain::numerics {

/// Fills `residuals`, shape (residuals), and `jacobian` dr_i/dp_j, shape (residuals, parameters),
/// row by row, at the given parameters.
using ResidualFunction = std::function<void(
    std::span<const double> parameters, std::span<double> residuals, std::span<double> jacobian)>;

/// Closed interval of one parameter.
struct ParameterBounds {
    double low = 0, high = 0;
};

struct LeastSquaresMinimum {
    std::vector<double> parameters;
    double squares = 0;  ///< sum of squared residuals
};

/// The minimum that `start` leads to. `bounds` is empty or of shape (parameters).
/// Nothing if no minimum is reached within 200 steps: in the end the undamped step must change no
/// parameter by more than 1e-6 of itself.
/// Throws std::invalid_argument for no parameters, fewer residuals than parameters, bounds of
/// another shape, a start outside of them, or a start at which the residuals are not finite.
[[nodiscard]] std::optional<LeastSquaresMinimum>
levenberg_marquardt(const ResidualFunction& function, std::size_t residuals,
                    std::span<const double> start, std::span<const ParameterBounds> bounds = {});

}  // namespace crossgrain::numerics
