#include "reference/analytic/step_map.hpp"

#include "reference/analytic/parameter_check.hpp"

#include <Eigen/Eigenvalues>

namespace crossgrain::analytic {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

bool carries_acceleration(TimeScheme scheme) {
    return scheme == TimeScheme::half_step_verlet || scheme == TimeScheme::predicted_verlet ||
           scheme == TimeScheme::crank_nicolson_leapfrog;
}

Matrix identity(Eigen::Index rows) {
    Matrix one(rows, rows);
    one.setIdentity();
    return one;
}

}  // namespace

StepMap::StepMap(TimeScheme scheme, const PackingMatrices& matrices, double dt)
    : scheme_(scheme), rows_(matrices.stiffness.rows()),
      blocks_(carries_acceleration(scheme) ? 3 : 2) {
    require_positive("dt", dt);
    stiffness_ = dt * dt * matrices.stiffness;
    damping_ = dt * matrices.damping;
    if (scheme == TimeScheme::crank_nicolson_leapfrog)
        implicit_.compute(identity(rows_) + 0.5 * damping_);
}

Vector StepMap::force(const Vector& u, const Vector& v) const {
    return -(stiffness_ * u) - damping_ * v;
}

void StepMap::operator()(const Vector& before, Vector& after) const {
    Vector u = before.head(rows_), v = before.segment(rows_, rows_);
    after.resize(size());
    switch (scheme_) {
    case TimeScheme::half_step_verlet:
    case TimeScheme::predicted_verlet:
    case TimeScheme::crank_nicolson_leapfrog: {
        const Vector a = before.tail(rows_);
        v += a / 2;
        u += v;
        if (scheme_ == TimeScheme::crank_nicolson_leapfrog) {
            v = implicit_.solve(v - stiffness_ * u / 2);
            after.tail(rows_) = force(u, v);
        } else {
            const bool predicted = scheme_ == TimeScheme::predicted_verlet;
            after.tail(rows_) = predicted ? force(u, v + a / 2) : force(u, v);
            v += after.tail(rows_) / 2;
        }
        break;
    }
    case TimeScheme::semi_implicit_euler:
        v += force(u, v);
        u += v;
        break;
    case TimeScheme::explicit_euler: {
        const Vector a = force(u, v);
        u += v;
        v += a;
        break;
    }
    case TimeScheme::taguchi_euler: {
        const Vector a = force(u, v);
        u += v + a / 2;
        v += a;
        break;
    }
    case TimeScheme::runge_kutta_4: {
        const Vector v1 = v, a1 = force(u, v);
        const Vector v2 = v + a1 / 2, a2 = force(u + v1 / 2, v2);
        const Vector v3 = v + a2 / 2, a3 = force(u + v2 / 2, v3);
        const Vector v4 = v + a3, a4 = force(u + v3, v4);
        u += (v1 + 2 * v2 + 2 * v3 + v4) / 6;
        v += (a1 + 2 * a2 + 2 * a3 + a4) / 6;
        break;
    }
    }
    after.head(rows_) = u;
    after.segment(rows_, rows_) = v;
}

double eigenpair_residual(const StepMap& map, std::complex<double> value,
                          const Eigen::VectorXcd& state) {
    Vector real, imaginary;
    map(state.real(), real);
    map(state.imag(), imaginary);
    Eigen::VectorXcd off = -value * state;
    off.real() += real;
    off.imag() += imaginary;
    return off.norm() / (std::abs(value) * state.norm());
}

ModeEigenpair dominant_of_mode(TimeScheme scheme, double frequency_squared, double damping_rate,
                               double dt) {
    const StepMap map(scheme, {frequency_squared * identity(1), damping_rate * identity(1)}, dt);
    Eigen::MatrixXd matrix(map.size(), map.size());
    Vector column;
    for (Eigen::Index j = 0; j < map.size(); ++j) {
        map(Vector::Unit(map.size(), j), column);
        matrix.col(j) = column;
    }
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix);
    Eigen::Index largest = 0;
    solver.eigenvalues().cwiseAbs().maxCoeff(&largest);
    return {solver.eigenvalues()(largest), solver.eigenvectors().col(largest)};
}

}  // namespace crossgrain::analytic
