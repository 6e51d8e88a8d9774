#include "reference/analytic/scheme_stability.hpp"

#include "reference/analytic/parameter_check.hpp"
#include "reference/analytic/stability_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace crossgrain::analytic {
namespace {

// The positive root h of w^2 h^2 + g c h = 4.
double limit_at_minus_one(double w, double c, double g) {
    const double b = g * c / 2;
    return 4 / (b + std::sqrt(b * b + 4 * w * w));
}

/// The two roots of l^2 + c l + w^2, w > 0, without cancellation.
std::array<std::complex<double>, 2> roots(double w, double c) {
    const auto root = std::sqrt(std::complex<double>(c * c / 4 - w * w));
    const auto larger = -c / 2 - root;
    return {larger, w * w / larger};
}

struct Mode {
    double frequency_squared, damping_rate;
};

// The two modes of the triangular lattice with wave vector q (unit bond length).
std::array<Mode, 2> lattice_modes(double qx, double qy, double k, double eta, Damping variant) {
    double xx = 0, xy = 0, yy = 0;
    for (int j = 0; j < 6; ++j) {
        const double nx = std::cos(j * std::numbers::pi / 3),
                     ny = std::sin(j * std::numbers::pi / 3);
        const double weight = 1 - std::cos(qx * nx + qy * ny);
        xx += weight * nx * nx;
        xy += weight * nx * ny;
        yy += weight * ny * ny;
    }
    const double mean = (xx + yy) / 2, split = std::hypot((xx - yy) / 2, xy);
    const auto mode = [&](double eigenvalue) {
        const bool full = variant == Damping::full_vector;
        return Mode{k * eigenvalue, eta * (full ? xx + yy : eigenvalue)};
    };
    return {mode(mean + split), mode(mean - split)};
}

}  // namespace

std::complex<double> growth_factor(TimeScheme scheme, std::complex<double> z) {
    if (scheme == TimeScheme::explicit_euler) return 1.0 + z;
    if (scheme == TimeScheme::runge_kutta_4)
        return 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
    throw std::domain_error(
        "only explicit Euler and Runge-Kutta multiply by a polynomial in mu dt");
}

double eigenvalue_time_step_limit(TimeScheme scheme, std::complex<double> mu) {
    if (scheme == TimeScheme::explicit_euler) return std::max(0.0, -2 * mu.real() / std::norm(mu));
    // The region of stability ends within |z| = 4 in every direction.
    double stable = 0, unstable = 4 / std::abs(mu);
    for (int i = 0; i < 60; ++i) {
        const double middle = (stable + unstable) / 2;
        (std::abs(growth_factor(scheme, middle * mu)) <= 1 ? stable : unstable) = middle;
    }
    return stable;
}

std::optional<double> damping_weight(TimeScheme scheme) {
    switch (scheme) {
    case TimeScheme::half_step_verlet:
    case TimeScheme::semi_implicit_euler:
        return 2;
    case TimeScheme::predicted_verlet:
        return 4;
    case TimeScheme::crank_nicolson_leapfrog:
        return 0;
    default:
        return std::nullopt;
    }
}

double mode_time_step_limit(TimeScheme scheme, double frequency, double damping_rate) {
    require_positive("frequency", frequency);
    require_not_negative("damping rate", damping_rate);
    if (const auto g = damping_weight(scheme)) {
        return limit_at_minus_one(frequency, damping_rate, *g);
    }
    if (scheme != TimeScheme::taguchi_euler) {
        const auto [first, second] = roots(frequency, damping_rate);
        return std::min(eigenvalue_time_step_limit(scheme, first),
                        eigenvalue_time_step_limit(scheme, second));
    }
    if (damping_rate == 0) return 0;
    return std::min(2 / damping_rate, 2 * damping_rate / (frequency * frequency));
}

double lattice_time_step_limit(TimeScheme scheme, double stiffness, double damping, double mass,
                               Damping damping_acts_on) {
    require_positive("stiffness", stiffness);
    require_not_negative("damping", damping);
    require_positive("mass", mass);
    constexpr int n = 120;
    double least = std::numeric_limits<double>::infinity();
    for (int a = 0; a <= n; ++a) {
        for (int b = 0; b <= n; ++b) {
            if (a == 0 && b == 0) continue;
            const double qx = 4 * std::numbers::pi / 3 * a / n;
            const double qy = 2 * std::numbers::pi / std::numbers::sqrt3 * b / n;
            for (const Mode& mode :
                 lattice_modes(qx, qy, stiffness / mass, damping / mass, damping_acts_on)) {
                if (mode.frequency_squared < 1e-9 * stiffness / mass) continue;
                least =
                    std::min(least, mode_time_step_limit(scheme, std::sqrt(mode.frequency_squared),
                                                         mode.damping_rate));
            }
        }
    }
    return least;
}

}  // namespace crossgrain::analytic
