#include "cases/measure/hopper/hopper_power_fit.hpp"

#include "native/numerics/levenberg_marquardt.hpp"
#include "native/numerics/line_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace crossgrain::measure {
namespace {

bool can_be_fitted(std::span<const double> x, std::span<const double> y) {
    const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
    if (x.size() != y.size() || x.size() < 2) return false;
    if (!std::ranges::all_of(x, positive) || !std::ranges::all_of(y, positive)) return false;
    return std::ranges::max(x) > std::ranges::min(x);
}

/// y = b z^a with z = x/x_max: for a given a the best b is linear least squares, which leaves a sum
/// of squares that depends on a alone (variable projection; Golub & Pereyra 1973).
class Projection {
  public:
    Projection(std::span<const double> x, std::span<const double> y) : y_(y) {
        const double largest = std::ranges::max(x);
        for (const double value : x)
            log_z_.push_back(std::log(value / largest));
        for (const double value : y)
            yy_ += value * value;
    }

    [[nodiscard]] double amplitude(double a) const {
        const auto [zy, zz] = sums(a);
        return zy / zz;
    }
    [[nodiscard]] double squares(double a) const {
        const auto [zy, zz] = sums(a);
        return yy_ - zy * zy / zz;
    }
    /// b z^a - y at the parameters a, b.
    [[nodiscard]] numerics::ResidualFunction residuals() const {
        return [this](std::span<const double> p, std::span<double> r, std::span<double> jacobian) {
            for (std::size_t i = 0; i < y_.size(); ++i) {
                const double z = std::exp(p[0] * log_z_[i]);
                r[i] = p[1] * z - y_[i];
                jacobian[2 * i] = p[1] * log_z_[i] * z;
                jacobian[2 * i + 1] = z;
            }
        };
    }

  private:
    struct Sums {
        double zy, zz;
    };
    [[nodiscard]] Sums sums(double a) const {
        Sums sums{};
        for (std::size_t i = 0; i < y_.size(); ++i) {
            const double z = std::exp(a * log_z_[i]);
            sums.zy += z * y_[i];
            sums.zz += z * z;
        }
        return sums;
    }

    std::span<const double> y_;
    std::vector<double> log_z_;
    double yy_ = 0;
};

}  // namespace

std::optional<PowerFit> fit_logarithms(std::span<const double> x, std::span<const double> y) {
    if (!can_be_fitted(x, y)) return std::nullopt;
    std::vector<double> log_x, log_y;
    for (std::size_t i = 0; i < x.size(); ++i) {
        log_x.push_back(std::log(x[i]));
        log_y.push_back(std::log(y[i]));
    }
    const numerics::Line line = numerics::line_through(log_x, log_y);
    return PowerFit{.exponent = line.slope, .amplitude = std::exp(line.intercept)};
}

std::optional<PowerFit> fit_unweighted(std::span<const double> x, std::span<const double> y) {
    if (!can_be_fitted(x, y)) return std::nullopt;
    constexpr double limit = 20, grid = 0.5;
    const Projection projection(x, y);
    // The coarse grid guards against a second, shallower minimum.
    double best = 0, least = std::numeric_limits<double>::infinity();
    for (double a = -limit; a <= limit; a += grid) {
        const double squares = projection.squares(a);
        if (squares < least) {
            least = squares;
            best = a;
        }
    }
    constexpr double largest = std::numeric_limits<double>::max();
    const auto minimum = numerics::levenberg_marquardt(
        projection.residuals(), x.size(), std::array{best, projection.amplitude(best)},
        std::array<numerics::ParameterBounds, 2>{
            {{best - grid, best + grid}, {-largest, largest}}});
    if (!minimum) return std::nullopt;
    const double a = minimum->parameters[0];
    return PowerFit{.exponent = a,
                    .amplitude = minimum->parameters[1] * std::pow(std::ranges::max(x), -a)};
}

}  // namespace crossgrain::measure
