// Eigenvalue of largest modulus of a linear map that is given by what it does to a vector.
#pragma once

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <functional>

namespace crossgrain::numerics {

/// y = M x for any x of the map's size.
using LinearMap = std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& y)>;

struct DominantEigenpair {
    std::complex<double> value;
    Eigen::VectorXcd vector;  ///< of length 1
    double residual = 0;      ///< |M x - z x|/(|z| |x|)
};

struct DominantSearch {
    /// The Krylov space is that of M^power: moduli that are nearly equal part as their powers do.
    /// Odd, so that z = 1 and z = -1 stay apart.
    int power = 1;
    std::size_t most_restarts = 100;
    double residual = 1e-6;  ///< largest that is accepted
};

/// |M x - z x|/(|z| |x|).
[[nodiscard]] double eigenpair_residual(const LinearMap& map, std::complex<double> value,
                                        const Eigen::VectorXcd& vector);

/// The pair of a real, in general not symmetric, map of `size` >= 8 dimensions, by the implicitly
/// restarted Arnoldi method (Spectra) and a Rayleigh-Ritz step of M itself in the space found.
/// Throws std::invalid_argument for a smaller size or an even power, and std::runtime_error if the
/// map gives numbers that are not finite or the residual stays above the one accepted.
[[nodiscard]] DominantEigenpair dominant_eigenpair(std::size_t size, const LinearMap& map,
                                                   const DominantSearch& search = {});

}  // namespace crossgrain::numerics
