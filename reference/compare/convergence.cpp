#include "reference/compare/convergence.hpp"

#include "native/numerics/line_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

namespace crossgrain::compare {
namespace {

void check(std::span<const Rung> rungs) {
    std::set<double> steps;
    for (const Rung& r : rungs) {
        const bool valid = std::isfinite(r.dt) && r.dt > 0 && std::isfinite(r.mean_error) &&
                           std::isfinite(r.rms_error) && r.rms_error > 0 &&
                           std::isfinite(r.mean_standard_error) && r.mean_standard_error >= 0 &&
                           std::isfinite(r.rms_standard_error) && r.rms_standard_error >= 0;
        if (!valid) {
            throw std::invalid_argument("a rung needs dt > 0, rms error > 0 and finite numbers");
        }
        steps.insert(r.dt);
    }
    if (steps.size() < 3) {
        throw std::invalid_argument("an order of convergence needs three different time steps");
    }
}

struct Fit {
    numerics::LineFit line;
    double degrees_of_freedom = 0;  // of its errors
};

Fit fit(std::span<const double> x, std::span<const double> y, std::span<const double> errors) {
    const auto unknown = std::ranges::count(errors, 0.0);
    if (unknown == std::ssize(errors)) {
        const numerics::LineFit line = numerics::fit_line(x, y);
        return {line, line.degrees_of_freedom};
    }
    if (unknown > 0) {
        throw std::invalid_argument("either all rungs of a ladder state an error or none does");
    }
    numerics::LineFit line = numerics::fit_line(x, y, errors);
    const double scatter = line.chi_squared / line.degrees_of_freedom;
    if (scatter <= 1) return {line, std::numeric_limits<double>::infinity()};
    line.scale_covariance(scatter);
    return {line, line.degrees_of_freedom};
}

}  // namespace

Convergence convergence(std::span<const Rung> rungs) {
    check(rungs);
    std::vector<double> dt, mean, mean_error, log_dt, log_rms, log_rms_error;
    for (const Rung& r : rungs) {
        dt.push_back(r.dt);
        mean.push_back(r.mean_error);
        mean_error.push_back(r.mean_standard_error);
        log_dt.push_back(std::log(r.dt));
        log_rms.push_back(std::log(r.rms_error));
        log_rms_error.push_back(r.rms_standard_error / r.rms_error);
    }
    const Fit order = fit(log_dt, log_rms, log_rms_error);
    const Fit limit = fit(dt, mean, mean_error);
    return {
        .order = {order.line.slope, order.line.slope_error(), order.degrees_of_freedom},
        .limit = {limit.line.intercept, limit.line.intercept_error(), limit.degrees_of_freedom}};
}

}  // namespace crossgrain::compare
