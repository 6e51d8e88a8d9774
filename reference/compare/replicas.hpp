// One measurement from the replicas (other seeds, same scene) of a run.
#pragma once

#include "cases/measure/results.hpp"

#include <span>

namespace crossgrain::compare {

/// What the standard error of a combination rests on.
enum class ErrorBasis {
    scatter,    ///< of the replicas
    within_run  ///< errors of the runs themselves
};

struct Combined {
    /// value: mean over the replicas, all weighted equally; n summed; systematic: mean (it is
    /// shared by the replicas and does not average out); settings: those that all replicas share
    /// but for rounding.
    measure::Measurement measurement;
    std::size_t replicas = 0;
    ErrorBasis basis = ErrorBasis::scatter;
    /// replicas - 1 for scatter, n - replicas within runs, infinite for an exact number (zero error
    /// of one run).
    double degrees_of_freedom = 0;
};

/// Four replicas or more: s/sqrt(replicas) with s their standard deviation, which needs no trust in
/// the error within a run. Fewer: sqrt(sum s_i^2)/replicas; if a run states no error (0) while the
/// replicas differ, their scatter, however few they are.
/// Throws std::invalid_argument for no replicas, different observables or units, or numbers that
/// are not finite.
[[nodiscard]] Combined combine(std::span<const measure::Measurement> replicas);

}  // namespace crossgrain::compare
