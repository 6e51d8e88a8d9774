#include "reference/analytic/scheme_stability.hpp"

#include "reference/analytic/parameter_check.hpp"
#include "reference/analytic/stability_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

namespace crossgrain::analytic {
namespace {

// The positive root h of w^2 h^2 + g c h = 4.
double limit_at_minus_one(double w, double c, double g) {
    const double b = g * c / 2;
    return 4 / (b + std::sqrt(b * b + 4 * w * w));
}

double explicit_euler_limit(double w, double c) {
    const double complex_pair = c / (w * w);
    const double radicand = c * c - 4 * w * w;
    if (radicand < 0) return complex_pair;
    // The smaller root of w^2 h^2 - 2 c h + 4 = 0 in the form without cancellation.
    return std::min(complex_pair, 4 / (c + std::sqrt(radicand)));
}

double runge_kutta_limit(double w, double c) {
    const auto root = std::sqrt(std::complex<double>(c * c / 4 - w * w));
    const auto growth = [&](double h) {
        double largest = 0;
        for (const auto l : {-c / 2 + root, -c / 2 - root}) {
            const auto z = l * h;
            largest = std::max(
                largest, std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))));
        }
        return largest;
    };
    // The region of stability ends within |z| = 4 in every direction.
    double stable = 0, unstable = 4 / std::max(std::abs(-c / 2 + root), std::abs(-c / 2 - root));
    for (int i = 0; i < 60; ++i) {
        const double middle = (stable + unstable) / 2;
        (growth(middle) <= 1 ? stable : unstable) = middle;
    }
    return stable;
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

// g in dt^2 D + g dt C, for the schemes that leave the unit disc at -1.
std::optional<double> weight_of_damping(TimeScheme scheme) {
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

}  // namespace

double mode_time_step_limit(TimeScheme scheme, double frequency, double damping_rate) {
    require_positive("frequency", frequency);
    require_not_negative("damping rate", damping_rate);
    if (const auto g = weight_of_damping(scheme)) {
        return limit_at_minus_one(frequency, damping_rate, *g);
    }
    if (scheme == TimeScheme::explicit_euler) return explicit_euler_limit(frequency, damping_rate);
    if (scheme == TimeScheme::runge_kutta_4) return runge_kutta_limit(frequency, damping_rate);
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

namespace {

struct Bond {
    std::size_t i, j;
    double nx, ny;
};

double nearest(double separation, const std::optional<double>& period) {
    return period ? separation - *period * std::round(separation / *period) : separation;
}

// a D + b C of a packing, applied bond by bond.
class PackingOperator {
  public:
    explicit PackingOperator(const ClosedPacking& p) : p_(p) {
        for (std::size_t i = 0; i < p.x.size(); ++i) {
            for (std::size_t j = i + 1; j < p.x.size(); ++j) {
                const double dy = nearest(p.y[i] - p.y[j], p.period_y);
                if (std::abs(dy) >= p.diameter) continue;
                const double dx = nearest(p.x[i] - p.x[j], p.period_x);
                const double r = std::hypot(dx, dy);
                if (r < p.diameter && r > 0) bonds_.push_back({i, j, dx / r, dy / r});
            }
            if (p.bottom && p.y[i] < *p.bottom) on_plate_.push_back(i);
            if (p.lid && p.y[i] > *p.lid) on_plate_.push_back(i);
        }
        vector_.resize(2 * p.x.size());
        // Any vector that is not an eigenvector; the same on every machine.
        for (std::size_t i = 0; i < vector_.size(); ++i)
            vector_[i] = std::sin(1.0 + 0.7 * static_cast<double>(i * i % 1009));
    }

    [[nodiscard]] bool empty() const { return bonds_.empty() && on_plate_.empty(); }

    /// Largest eigenvalue (Rayleigh's quotient) of a D + b C; starts from the vector of the call
    /// before.
    double largest_eigenvalue(double a, double b) {
        double value = 0;
        for (int round = 0; round < 20000; ++round) {
            const std::vector<double> image = apply(a, b);
            double dot = 0, square = 0;
            for (std::size_t i = 0; i < image.size(); ++i) {
                dot += image[i] * vector_[i];
                square += image[i] * image[i];
            }
            const double norm = std::sqrt(square);
            for (std::size_t i = 0; i < image.size(); ++i)
                vector_[i] = image[i] / norm;
            const double before = std::exchange(value, round == 0 ? 0 : dot);
            // Slow where many modes are near the largest; the quotient is then near as well.
            if (round > 20 && std::abs(value - before) < 1e-8 * value) break;
        }
        return value;
    }

  private:
    [[nodiscard]] std::vector<double> apply(double a, double b) const {
        std::vector<double> image(vector_.size(), 0.0);
        const bool full = p_.damping_acts_on == Damping::full_vector;
        const double along = (a * p_.stiffness + b * p_.damping) / p_.mass;
        const double across = full ? b * p_.damping / p_.mass : 0.0;
        for (const Bond& bond : bonds_) {
            const double ux = vector_[2 * bond.i] - vector_[2 * bond.j];
            const double uy = vector_[2 * bond.i + 1] - vector_[2 * bond.j + 1];
            const double normal = (along - across) * (ux * bond.nx + uy * bond.ny);
            const double fx = normal * bond.nx + across * ux;
            const double fy = normal * bond.ny + across * uy;
            image[2 * bond.i] += fx;
            image[2 * bond.i + 1] += fy;
            image[2 * bond.j] -= fx;
            image[2 * bond.j + 1] -= fy;
        }
        for (const std::size_t i : on_plate_)
            image[2 * i + 1] += a * p_.plate_stiffness / p_.mass * vector_[2 * i + 1];
        return image;
    }

    const ClosedPacking& p_;
    std::vector<Bond> bonds_;
    std::vector<std::size_t> on_plate_;
    std::vector<double> vector_;  ///< shape (2 grains): x and y of each
};

}  // namespace

double largest_packing_frequency(const ClosedPacking& packing) {
    PackingOperator matrix(packing);
    return matrix.empty() ? 0.0 : std::sqrt(matrix.largest_eigenvalue(1, 0));
}

std::optional<double> packing_time_step_limit(TimeScheme scheme, const ClosedPacking& packing) {
    const auto g = weight_of_damping(scheme);
    PackingOperator matrix(packing);
    if (!g || matrix.empty()) return std::nullopt;
    const double undamped = 2 / std::sqrt(matrix.largest_eigenvalue(1, 0));
    if (*g == 0 || packing.damping == 0) return undamped;
    double stable = 0, unstable = undamped;
    while (unstable - stable > 1e-5 * unstable) {
        const double middle = (stable + unstable) / 2;
        const bool holds = matrix.largest_eigenvalue(middle * middle, *g * middle) <= 4;
        (holds ? stable : unstable) = middle;
    }
    return (stable + unstable) / 2;
}

}  // namespace crossgrain::analytic
