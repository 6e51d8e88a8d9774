// One time step of an integration scheme on u'' = -K u - C u', as a linear map.
//
// The state is (u, h v) or, for schemes that carry the acceleration from step to step, (u, h v,
// h^2 a), h the time step: all of it has the unit of u, and the map depends on h^2 K and h C alone.
// A step is stable while no eigenvalue of the map lies outside of the unit disc. Each scheme is
// written as native/dem states it, without sharing its code.
#pragma once

#include "reference/analytic/closed_packing.hpp"
#include "reference/analytic/time_scheme.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include <complex>

namespace crossgrain::analytic {

class StepMap {
  public:
    /// `dt` (t) > 0; throws std::domain_error otherwise.
    StepMap(TimeScheme scheme, const PackingMatrices& matrices, double dt);

    /// Dimensions of the state: two or three times those of u.
    [[nodiscard]] Eigen::Index size() const noexcept { return blocks_ * rows_; }
    void operator()(const Eigen::VectorXd& before, Eigen::VectorXd& after) const;

  private:
    [[nodiscard]] Eigen::VectorXd force(const Eigen::VectorXd& u, const Eigen::VectorXd& v) const;

    TimeScheme scheme_;
    Eigen::Index rows_, blocks_;
    Eigen::SparseMatrix<double> stiffness_, damping_;  ///< h^2 K, h C
    /// 1 + h C/2, which Crank-Nicolson damping divides by.
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> implicit_;
};

/// |M s - z s|/(|z| |s|) of a map M, its state s and the eigenvalue z that it is to have.
[[nodiscard]] double eigenpair_residual(const StepMap& map, std::complex<double> value,
                                        const Eigen::VectorXcd& state);

/// Eigenvalue of largest modulus of the scheme's map of one mode, of squared frequency
/// `frequency_squared` (1/t^2) and damping rate `damping_rate` (1/t), with its state, shape (2 or
/// 3).
struct ModeEigenpair {
    std::complex<double> value;
    Eigen::VectorXcd state;
};
[[nodiscard]] ModeEigenpair dominant_of_mode(TimeScheme scheme, double frequency_squared,
                                             double damping_rate, double dt);

}  // namespace crossgrain::analytic
