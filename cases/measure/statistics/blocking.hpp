// Mean of a correlated series and its standard error by blocking
// (Flyvbjerg & Petersen, J. Chem. Phys. 91, 461 (1989)).
//
// Neighbouring values are averaged in pairs again and again; the naive standard error of the
// blocks, s_B/sqrt(n/B), grows with the block length B until blocks are independent. The block
// length is the smallest with B^3 > 2 n (err_B/err_1)^4 (Lee et al., Phys. Rev. E 83, 066706
// (2011)), which balances the remaining correlation against the noise of the error itself.
//
// That choice looks at the noise, and where few blocks are left it picks errors that are too small
// by luck. It is taken only while 16 blocks or more remain; otherwise the series is cut into six
// equal batches whatever they look like (batch means; Law, Simulation Modeling and Analysis, 5th
// ed. (2015), section 9.5.3), unless these drift: von Neumann's ratio of the mean squared
// successive difference to the variance is below 0.6 (independent batches: 15 in 1000). Then the
// error is that of its two halves, which rests on one degree of freedom and claims little.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace crossgrain::measure {

struct BlockedMean {
    double value = 0;
    double standard_error = 0;
    std::size_t blocks = 0;  ///< independent samples behind the error
};

/// Nothing for fewer than twelve values. The error rests on blocks - 1 degrees of freedom; with two
/// blocks the run is too short for its correlation time. A constant series has standard error 0.
[[nodiscard]] std::optional<BlockedMean> blocked_mean(std::span<const double> series);

}  // namespace crossgrain::measure
