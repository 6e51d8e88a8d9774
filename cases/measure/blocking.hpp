// Mean of a correlated series and its standard error by blocking
// (Flyvbjerg & Petersen, J. Chem. Phys. 91, 461 (1989)).
//
// Neighbouring values are averaged in pairs again and again; the naive standard error of the
// blocks, s_B/sqrt(n/B), grows with the block length B until blocks are independent. The block
// length is the smallest with B^3 > 2 n (err_B/err_1)^4 (Lee et al., Phys. Rev. E 83, 066706
// (2011)), which balances the remaining correlation against the noise of the error itself.
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

/// Nothing if the series is too short for its correlation time (no block length qualifies, or
/// fewer than eight blocks remain). A constant series has standard error 0.
[[nodiscard]] std::optional<BlockedMean> blocked_mean(std::span<const double> series);

}  // namespace crossgrain::measure
