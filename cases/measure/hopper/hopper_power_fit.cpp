#include "cases/measure/hopper/hopper_power_fit.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
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
    const double n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / n;
        mean_y += std::log(y[i]) / n;
    }
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = std::log(x[i]) - mean_x;
        xx += dx * dx;
        xy += dx * (std::log(y[i]) - mean_y);
    }
    const double a = xy / xx;
    return PowerFit{.exponent = a, .amplitude = std::exp(mean_y - a * mean_x)};
}

std::optional<PowerFit> fit_unweighted(std::span<const double> x, std::span<const double> y) {
    const auto start = fit_logarithms(x, y);
    if (!start) return std::nullopt;
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
    constexpr int bits = 40;
    const auto minimum = boost::math::tools::brent_find_minima(
        [&](double a) { return projection.squares(a); }, best - grid, best + grid, bits);
    const double a = minimum.first;
    const double b = projection.amplitude(a) * std::pow(std::ranges::max(x), -a);
    return PowerFit{.exponent = a, .amplitude = b};
}

}  // namespace crossgrain::measure
