#include "reference/analytic/packing_stability.hpp"

#include "native/numerics/dominant_eigenpair.hpp"
#include "native/numerics/joint_modes.hpp"
#include "native/numerics/symmetric_eigenpair.hpp"
#include "reference/analytic/scheme_stability.hpp"
#include "reference/analytic/step_map.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
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
    return {.dt = dt,
            .eigenvalue = mode.value,
            .residual = numerics::eigenpair_residual(std::cref(map), mode.value, state)};
}

PackingLimit limit_at_minus_one(TimeScheme scheme, const PackingMatrices& m, double g) {
    const auto extreme = [&](double dt) {
        const Matrix a = dt * dt * m.stiffness + g * dt * m.damping;
        const auto pair = numerics::largest_eigenpair(a, {.residual = 1e-7});
        return Vector(Eigen::Map<const Vector>(pair.vector.data(), a.rows()));
    };
    double dt = 2 / std::sqrt(numerics::largest_eigenpair(m.stiffness, {.residual = 1e-7}).value);
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

/// Near the limit of any scheme: 2 over the largest frequency or damping rate.
double first_guess(const PackingMatrices& m) {
    const double frequency = std::sqrt(numerics::largest_eigenpair(m.stiffness).value);
    return 2 / std::max(frequency, numerics::largest_eigenpair(m.damping).value);
}

/// The eigenvalue of largest modulus of the packing's map, its translations left out: they have
/// z = 1 twice, with one state, which round-off splits into moduli on both sides of 1.
class SpectralRadius {
  public:
    SpectralRadius(TimeScheme scheme, const PackingMatrices& m)
        : scheme_(scheme), matrices_(m),
          free_along_y_(is_null(m, translation(m.stiffness.rows(), 1))) {}

    [[nodiscard]] numerics::DominantEigenpair at(double dt) const {
        const StepMap map(scheme_, matrices_, dt);
        const numerics::LinearMap relative = [&](const Vector& before, Vector& after) {
            map(before, after);
            remove_translations(after);
        };
        return numerics::dominant_eigenpair(static_cast<std::size_t>(map.size()), relative,
                                            {.power = 255});
    }

  private:
    static Vector translation(Eigen::Index rows, Eigen::Index axis) {
        Vector t = Vector::Zero(rows);
        t(Eigen::seq(axis, Eigen::last, 2)).setOnes();
        return t;
    }

    static bool is_null(const PackingMatrices& m, const Vector& u) {
        constexpr double round_off = 1e-12;
        return (m.stiffness * u).norm() <= round_off * m.stiffness.norm() * u.norm() &&
               (m.damping * u).norm() <= round_off * m.damping.norm() * u.norm();
    }

    void remove_translations(Vector& state) const {
        const Eigen::Index rows = matrices_.stiffness.rows();
        for (Eigen::Index block = 0; block < state.size(); block += rows) {
            for (Eigen::Index axis = 0; axis < (free_along_y_ ? 2 : 1); ++axis) {
                auto along = state(Eigen::seqN(block + axis, rows / 2, 2));
                along.array() -= along.mean();
            }
        }
    }

    TimeScheme scheme_;
    const PackingMatrices& matrices_;
    bool free_along_y_;  ///< no plates; along x there are none
};

/// A time step and |z| - 1 there.
struct Growth {
    double dt = 0, rate = 0;
};

/// Brackets the limit and closes in on it: the growth is nearly linear above the limit, whose
/// extrapolation from the two lowest unstable steps is tried from both sides; every third step
/// bisects. Below the limit the growth says nothing: other modes have the largest modulus there.
PackingLimit limit_by_spectral_radius(TimeScheme scheme, const PackingMatrices& m) {
    // Parts of the packing that move freely against each other have z = 1 twice as well.
    constexpr double outside = 1e-7, resolution = 1e-5;
    const SpectralRadius radius(scheme, m);
    numerics::DominantEigenpair pair;
    const auto growth = [&](double dt) {
        pair = radius.at(dt);
        return std::abs(pair.value) - 1;
    };
    double stable = 0;
    Growth unstable{.dt = first_guess(m)}, before;
    // In small steps, so that the powers of the map do not overflow.
    while ((unstable.rate = growth(unstable.dt)) <= outside)
        stable = std::exchange(unstable.dt, 1.5 * unstable.dt);
    numerics::DominantEigenpair critical = pair;
    double side = -1;
    for (int round = 1; unstable.dt - stable > resolution * unstable.dt; ++round) {
        double next = (stable + unstable.dt) / 2;
        if (before.dt > 0 && round % 3 != 0) {
            const double root = unstable.dt - unstable.rate * (before.dt - unstable.dt) /
                                                  (before.rate - unstable.rate);
            const double beside = root * (1 + side * resolution / 3);
            if (beside > stable && beside < unstable.dt) next = beside;
        }
        const double rate = growth(next);
        side = rate > outside ? -1 : 1;
        if (rate > outside) {
            before = std::exchange(unstable, {next, rate});
            critical = pair;
        } else {
            stable = next;
        }
    }
    return {.dt = (stable + unstable.dt) / 2,
            .eigenvalue = critical.value,
            .residual = critical.residual};
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
    return limit_by_spectral_radius(scheme, m);
}

}  // namespace crossgrain::analytic
