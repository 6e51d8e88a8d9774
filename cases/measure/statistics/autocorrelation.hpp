// Integrated autocorrelation time of one series and the standard error of its mean, with the window
// chosen automatically (Wolff, Comput. Phys. Commun. 156, 143 (2004), the Gamma method for one
// observable and one replica).
//
//   Gamma(t)  autocovariance at lag t,  rho(t) = Gamma(t)/Gamma(0)
//   tau(W)  = 1/2 + sum_{t=1}^{W} rho(t)
// The window W is the first at which the systematic error of cutting the sum, exp(-W/tau_W), falls
// below the statistical one: g(W) = exp(-W/tau_W) - tau_W/sqrt(W n) < 0 with
// tau_W = S/ln((2 tau + 1)/(2 tau - 1)) and S = 1.5 (Wolff, Eqs. 50-52); where neighbours are
// anticorrelated and tau < 1/2, tau_W = -S/ln|rho(1)|, the same for an exponential. The bias of
// subtracting the measured mean is put back to first order, tau (1 + (2 W + 1)/n) (Eq. 49).
//   standard error of the mean  sqrt(2 tau Gamma(0)/n)
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace crossgrain::measure {

struct AutocorrelatedMean {
    double value = 0;
    double standard_error = 0;
    double time = 0.5;       ///< tau, in samples; 1/2 for independent ones
    double time_error = 0;   ///< tau sqrt(4 (W + 1/2 - tau)/n) (Wolff, Eq. 42)
    std::size_t window = 0;  ///< W
    double independent = 0;  ///< n/(2 tau): as many independent samples
};

/// Nothing for fewer than 32 samples, or for less than 16 independent ones: the run is too short
/// for its correlation time. A constant series has standard error 0.
[[nodiscard]] std::optional<AutocorrelatedMean> autocorrelated_mean(std::span<const double> series);

}  // namespace crossgrain::measure
