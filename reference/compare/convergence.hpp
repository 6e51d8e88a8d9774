// Order of convergence and limit of vanishing time step from a ladder of runs.
//
// The dashpot force jumps when a contact begins, so the error of one collision depends on where in
// the time step it begins. Over random phases the rms error falls as dt^p with p the order (1 for
// every fixed-step scheme with such a jump), and the mean error is a smooth function of dt with an
// extrapolated limit that must be 0.
//   log rms = log C + p log dt,   weights (rms/s_rms)^2
//   mean    = limit + slope dt,   weights 1/s_mean^2
#pragma once

#include <span>

namespace crossgrain::compare {

/// One time step of the ladder.
struct Rung {
    double dt = 0;          ///< (t), > 0
    double mean_error = 0;  ///< mean over collisions of (measured - exact)
    double mean_standard_error = 0;
    double rms_error = 0;  ///< > 0
    double rms_standard_error = 0;
};

struct Estimate {
    double value = 0;
    double standard_error = 0;
    double degrees_of_freedom = 0;
};

struct Convergence {
    Estimate order;  ///< p
    Estimate limit;  ///< mean error at dt -> 0
};

/// Standard errors are widened by sqrt(chi^2/dof) where that exceeds 1 (points that scatter more
/// than their errors allow do not lie on the line), and then rest on rungs - 2 degrees of freedom;
/// else they rest on the stated errors alone (infinite degrees of freedom). Errors that are all 0
/// count as unknown and equal and are estimated from the residuals.
/// Throws std::invalid_argument for fewer than three different time steps, numbers out of range, or
/// errors of which some but not all are 0.
[[nodiscard]] Convergence convergence(std::span<const Rung> rungs);

}  // namespace crossgrain::compare
