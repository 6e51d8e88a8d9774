#include "reference/analytic/packing_stability.hpp"

#include "native/numerics/damped_modes.hpp"
#include "native/numerics/joint_modes.hpp"
#include "native/numerics/symmetric_eigenpair.hpp"
#include "reference/analytic/scheme_stability.hpp"
#include "reference/analytic/step_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace crossgrain::analytic {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// The limit of one mode with the residual of its state in the map of the whole packing.
PackingLimit limit_of_mode(TimeScheme scheme, const PackingMatrices& m, const Vector& u,
                           double dt) {
    const ModeEigenpair mode =
        dominant_of_mode(scheme, u.dot(m.stiffness * u), u.dot(m.damping * u), dt);
    Eigen::VectorXcd state(mode.state.size() * u.size());
    for (Eigen::Index block = 0; block < mode.state.size(); ++block)
        state.segment(block * u.size(), u.size()) = mode.state(block) * u;
    const StepMap map(scheme, m, dt);
    return {
        .dt = dt, .eigenvalue = mode.value, .residual = eigenpair_residual(map, mode.value, state)};
}

PackingLimit limit_at_minus_one(TimeScheme scheme, const PackingMatrices& m, double g) {
    const auto extreme = [&](double dt) {
        const Matrix a = dt * dt * m.stiffness + g * dt * m.damping;
        const auto pair = numerics::largest_eigenpair(a, {.residual = 1e-9});
        return Vector(Eigen::Map<const Vector>(pair.vector.data(), a.rows()));
    };
    double dt = 2 / std::sqrt(numerics::largest_eigenpair(m.stiffness, {.residual = 1e-9}).value);
    for (int round = 0; round < 50; ++round) {
        const Vector u = extreme(dt);
        const double next =
            mode_time_step_limit(scheme, std::sqrt(u.dot(m.stiffness * u)), u.dot(m.damping * u));
        const bool settled = std::abs(next - dt) <= 1e-12 * dt;
        dt = next;
        if (settled) break;
    }
    return limit_of_mode(scheme, m, extreme(dt), dt);
}

PackingLimit limit_of_modes(TimeScheme scheme, const PackingMatrices& m,
                            const numerics::JointModes& modes) {
    const double stiff = modes.first.maxCoeff(), damped = modes.second.maxCoeff();
    double least = std::numeric_limits<double>::infinity();
    Eigen::Index at = 0;
    for (Eigen::Index i = 0; i < modes.first.size(); ++i) {
        constexpr double round_off = 1e-9;
        const bool springs = modes.first(i) > round_off * stiff;
        const bool dashpots = modes.second(i) > round_off * damped;
        if (!springs && !dashpots) continue;  // moves freely
        const double limit = mode_time_step_limit(
            scheme, std::sqrt(std::max(modes.first(i), round_off * round_off * stiff)),
            dashpots ? modes.second(i) : 0.0);
        if (limit >= least) continue;
        least = limit;
        at = i;
    }
    if (least == 0) return {};
    return limit_of_mode(scheme, m, modes.vectors.col(at), least);
}

/// The least limit over the eigenvalues mu of u'' = -K u - C u' in explicit Euler or Runge-Kutta.
struct CriticalEigenvalue {
    double dt = std::numeric_limits<double>::infinity();
    std::complex<double> mu;
};

CriticalEigenvalue critical_eigenvalue(TimeScheme scheme, const Matrix& k, const Matrix& c) {
    const Eigen::VectorXcd all = numerics::damped_eigenvalues(k, c);
    // What moves freely has mu = 0 twice, with one state, which round-off splits by its root.
    const double fastest = all.cwiseAbs().maxCoeff(), free = 1e-6 * fastest;
    CriticalEigenvalue critical;
    for (const std::complex<double> mu : all) {
        if (std::abs(mu) <= free) continue;
        const double limit = eigenvalue_time_step_limit(scheme, mu);
        if (limit < critical.dt) critical = {limit, mu};
    }
    return critical;
}

/// State (u, h v) and eigenvalue of the map from the mode of `mu` in the matrices k and c.
PackingLimit limit_of_eigenvalue(TimeScheme scheme, const PackingMatrices& m, double dt,
                                 std::complex<double> z, const numerics::DampedMode& mode) {
    const Eigen::Index rows = mode.vector.size();
    const bool taguchi = scheme == TimeScheme::taguchi_euler;
    Eigen::VectorXcd state(2 * rows);
    state.head(rows) = mode.vector;
    // Taguchi's u grows by h v + h^2 a/2 = (h v) (1 + (z - 1)/2), h v by (h v) (z - 1).
    state.tail(rows) = mode.vector * (taguchi ? 2.0 * (z - 1.0) / (z + 1.0) : mode.eigenvalue * dt);
    const StepMap map(scheme, m, dt);
    return {.dt = dt, .eigenvalue = z, .residual = eigenpair_residual(map, z, state)};
}

PackingLimit limit_of_damped_modes(TimeScheme scheme, const PackingMatrices& m) {
    const auto [dt, mu] = critical_eigenvalue(scheme, m.stiffness, m.damping);
    if (dt == 0) return {};
    return limit_of_eigenvalue(scheme, m, dt, growth_factor(scheme, mu * dt),
                               numerics::damped_mode(m.stiffness, m.damping, mu));
}

/// With y = (z - 1)/h the map of Taguchi's Euler has y^2 + y (C + h K/2) + K = 0: it is explicit
/// Euler with more damping, which depends on h. The limit is where that scheme's limit is h; the
/// secant method finds it.
PackingLimit limit_of_taguchi(const PackingMatrices& m) {
    constexpr double resolution = 1e-9;
    constexpr int most_rounds = 20;
    const auto damping = [&](double dt) { return Matrix(m.damping + dt / 2 * m.stiffness); };
    CriticalEigenvalue critical;
    const auto excess = [&](double dt) {
        critical = critical_eigenvalue(TimeScheme::explicit_euler, m.stiffness, damping(dt));
        return critical.dt - dt;
    };
    double before = 0, excess_before = excess(0);
    // For one mode of little damping it is twice that of explicit Euler.
    double dt = 2 * excess_before;
    if (dt == 0) return {};
    for (int round = 0; round < most_rounds; ++round) {
        const double here = excess(dt);
        if (std::abs(here) <= resolution * dt) break;
        const double next = dt - here * (before - dt) / (excess_before - here);
        before = std::exchange(dt, next);
        excess_before = here;
    }
    if (!(std::abs(critical.dt - dt) <= 1e-6 * dt)) {
        throw std::runtime_error("the time-step limit of Taguchi's Euler has not converged");
    }
    const std::complex<double> z = growth_factor(TimeScheme::explicit_euler, critical.mu * dt);
    return limit_of_eigenvalue(TimeScheme::taguchi_euler, m, dt, z,
                               numerics::damped_mode(m.stiffness, damping(dt), critical.mu));
}

}  // namespace

PackingFrequency largest_packing_frequency(const ClosedPacking& packing) {
    const PackingMatrices m = packing_matrices(packing);
    if (m.stiffness.rows() == 0) return {};
    const auto pair = numerics::largest_eigenpair(m.stiffness);
    return {.value = std::sqrt(pair.value), .residual = pair.residual};
}

std::optional<PackingLimit> packing_time_step_limit(TimeScheme scheme,
                                                    const ClosedPacking& packing) {
    const PackingMatrices m = packing_matrices(packing);
    if (m.stiffness.rows() == 0) return std::nullopt;
    if (const auto g = damping_weight(scheme)) return limit_at_minus_one(scheme, m, *g);
    if (const auto modes = numerics::joint_modes(m.stiffness, m.damping))
        return limit_of_modes(scheme, m, *modes);
    if (scheme == TimeScheme::taguchi_euler) return limit_of_taguchi(m);
    return limit_of_damped_modes(scheme, m);
}

}  // namespace crossgrain::analytic
