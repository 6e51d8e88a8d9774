#include "native/numerics/levenberg_marquardt.hpp"
#include "native/numerics/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace crossgrain::numerics {
namespace {

/// The function at one point.
struct Linearisation {
    std::vector<double> parameters, residuals, jacobian;
    double squares = 0;
};

class Minimiser {
  public:
    Minimiser(const ResidualFunction& function, std::size_t residuals,
              std::span<const ParameterBounds> bounds)
        : function_(function), rows_(residuals), bounds_(bounds) {}

    [[nodiscard]] Linearisation at(std::vector<double> parameters) const {
        Linearisation here{.parameters = std::move(parameters),
                           .residuals = std::vector<double>(rows_)};
        here.jacobian.resize(rows_ * here.parameters.size());
        function_(here.parameters, here.residuals, here.jacobian);
        here.squares = std::inner_product(here.residuals.begin(), here.residuals.end(),
                                          here.residuals.begin(), 0.0);
        const bool finite =
            std::isfinite(here.squares) &&
            std::ranges::all_of(here.jacobian, [](double d) { return std::isfinite(d); });
        if (!finite) here.squares = std::numeric_limits<double>::infinity();
        return here;
    }

    [[nodiscard]] std::optional<LeastSquaresMinimum> from(Linearisation here) const {
        constexpr int most_steps = 200;
        constexpr double smallest_step = 1e-14;  // relative; round-off of the parameters
        double lambda = 1e-3;
        for (int step = 0; step < most_steps; ++step) {
            const std::vector<double> next = proposal(here, lambda);
            if (change(here.parameters, next) <= smallest_step) {
                if (!is_minimum(here)) return std::nullopt;
                return LeastSquaresMinimum{here.parameters, here.squares};
            }
            Linearisation there = at(next);
            const bool lower = there.squares < here.squares;
            if (lower) here = std::move(there);
            lambda = std::clamp(lower ? lambda / 10 : lambda * 10, 1e-15, 1e30);
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] double norm(const Linearisation& here, std::size_t j) const {
        double sum = 0;
        for (std::size_t i = 0; i < rows_; ++i)
            sum += std::pow(here.jacobian[i * here.parameters.size() + j], 2);
        return std::sqrt(sum);
    }

    /// Half the derivative of the sum of squares.
    [[nodiscard]] double gradient(const Linearisation& here, std::size_t j) const {
        double sum = 0;
        for (std::size_t i = 0; i < rows_; ++i)
            sum += here.jacobian[i * here.parameters.size() + j] * here.residuals[i];
        return sum;
    }

    /// Whether the parameter is on a bound beyond which the sum falls, or does not matter here.
    [[nodiscard]] bool is_held(const Linearisation& here, std::size_t j) const {
        if (norm(here, j) == 0) return true;
        if (bounds_.empty()) return false;
        const double slope = gradient(here, j);
        return (here.parameters[j] <= bounds_[j].low && slope > 0) ||
               (here.parameters[j] >= bounds_[j].high && slope < 0);
    }

    /// Largest relative change of a parameter.
    [[nodiscard]] static double change(const std::vector<double>& from,
                                       const std::vector<double>& to) {
        constexpr double smallest = 1e-3;  // a parameter near 0 counts as that
        double largest = 0;
        for (std::size_t j = 0; j < from.size(); ++j) {
            largest = std::max(largest,
                               std::abs(to[j] - from[j]) / std::max(std::abs(from[j]), smallest));
        }
        return largest;
    }

    /// Whether the undamped step is short as well: heavy damping makes any step short.
    [[nodiscard]] bool is_minimum(const Linearisation& here) const {
        constexpr double undamped = 1e-15, shortest = 1e-6;
        return change(here.parameters, proposal(here, undamped)) <= shortest;
    }

    /// The parameters after a step, cut off at the bounds.
    [[nodiscard]] std::vector<double> proposal(const Linearisation& here, double lambda) const {
        const std::size_t all = here.parameters.size();
        std::vector<std::size_t> free;
        for (std::size_t j = 0; j < all; ++j)
            if (!is_held(here, j)) free.push_back(j);
        std::vector<double> next = here.parameters;
        if (free.empty()) return next;
        const std::size_t columns = free.size(), rows = rows_ + columns;
        std::vector<double> design(rows * columns, 0.0), target(rows, 0.0);
        for (std::size_t i = 0; i < rows_; ++i) {
            target[i] = -here.residuals[i];
            for (std::size_t f = 0; f < columns; ++f)
                design[i * columns + f] = here.jacobian[i * all + free[f]] / norm(here, free[f]);
        }
        for (std::size_t f = 0; f < columns; ++f)
            design[(rows_ + f) * columns + f] = std::sqrt(lambda);
        const LeastSquaresFit step =
            fit_linear(design, columns, target, std::vector<double>(rows, 1.0));
        for (std::size_t f = 0; f < columns; ++f) {
            double& p = next[free[f]];
            p += step.coefficients[f] / norm(here, free[f]);
            if (!bounds_.empty()) p = std::clamp(p, bounds_[free[f]].low, bounds_[free[f]].high);
        }
        return next;
    }

    const ResidualFunction& function_;
    std::size_t rows_;
    std::span<const ParameterBounds> bounds_;
};

void check(std::size_t residuals, std::span<const double> start,
           std::span<const ParameterBounds> bounds) {
    if (start.empty() || residuals < start.size()) {
        throw std::invalid_argument(
            "non-linear least squares need a parameter and as many residuals as parameters");
    }
    if (!bounds.empty() && bounds.size() != start.size()) {
        throw std::invalid_argument("non-linear least squares need bounds for every parameter");
    }
    for (std::size_t j = 0; j < bounds.size(); ++j) {
        if (!(bounds[j].low <= start[j] && start[j] <= bounds[j].high)) {
            throw std::invalid_argument("non-linear least squares start outside of the bounds");
        }
    }
}

}  // namespace

std::optional<LeastSquaresMinimum> levenberg_marquardt(const ResidualFunction& function,
                                                       std::size_t residuals,
                                                       std::span<const double> start,
                                                       std::span<const ParameterBounds> bounds) {
    check(residuals, start, bounds);
    const Minimiser minimiser(function, residuals, bounds);
    Linearisation here = minimiser.at({start.begin(), start.end()});
    if (!std::isfinite(here.squares)) {
        throw std::invalid_argument("non-linear least squares: residuals that are not finite at "
                                    "the start");
    }
    return minimiser.from(std::move(here));
}

}  // namespace crossgrain::numerics
