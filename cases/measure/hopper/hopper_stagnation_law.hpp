// P(theta) of one run: its power law and its critical angle, and their errors over several runs.
#pragma once

#include "cases/measure/hopper/hopper_power_fit.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace crossgrain::measure {

/// P at each angle; shape (angles), angles in degrees, in any order.
struct AngleSweep {
    std::vector<double> angles;
    std::vector<double> p;
};

enum class StagnationFit { unweighted, log, tan_unweighted, tan_log };

/// One definition of the exponent: what is fitted and over which angles.
struct StagnationLaw {
    StagnationFit fit = StagnationFit::log;
    double from = 0, to = 0;                 ///< degrees, both included
    [[nodiscard]] std::string name() const;  ///< e.g. "log_13_90"
};

/// Both fits in theta and in tan(theta/2), over 10-90, 13-90, 20-90 and 30-90 degrees.
[[nodiscard]] std::vector<StagnationLaw> stagnation_laws();

/// Fit of 1/P over the law's angles. Nothing if these do not cover the window (within one degree)
/// with ten angles or more, or if a P in it is not positive.
[[nodiscard]] std::optional<PowerFit> fit_stagnation(const StagnationLaw& law,
                                                     const AngleSweep& sweep);

/// Where P, averaged over half a degree on both sides of each angle, first falls below the
/// threshold (interpolated linearly). Nothing for fewer than three angles, if P is already below it
/// at the lowest angle, if it never falls below it, or if angles up to there are more than a degree
/// apart.
[[nodiscard]] std::optional<double> end_of_mass_flow(const AngleSweep& sweep, double threshold);

/// A number with its statistical error.
struct SweepEstimate {
    double value = 0;
    double standard_error = 0;
    std::size_t n = 0;  ///< replicas, or angles if the error is a bootstrap over these
};

/// A statistic of one sweep; nothing where it does not exist.
using SweepStatistic = std::function<std::optional<double>(const AngleSweep&)>;

/// Mean of `statistic` over the replicas' sweeps. Error: scatter of four or more replicas; of
/// fewer, bootstrap over the angles (each has its own random numbers, so they are independent;
/// Efron & Tibshirani 1993, section 6). Nothing if the statistic is missing for any replica.
[[nodiscard]] std::optional<SweepEstimate> over_replicas(std::span<const AngleSweep> replicas,
                                                         std::uint64_t seed,
                                                         const SweepStatistic& statistic);

/// `statistic` of the sweeps' mean: for statistics that the scatter of a single P would bias.
/// Error: jackknife over two or more replicas, bootstrap over the angles of a single one. Nothing
/// if the statistic is missing for the mean or for any that the jackknife leaves.
[[nodiscard]] std::optional<SweepEstimate> of_replica_mean(std::span<const AngleSweep> replicas,
                                                           std::uint64_t seed,
                                                           const SweepStatistic& statistic);

/// P averaged over sweeps of the same angles; at least one.
[[nodiscard]] AngleSweep mean_sweep(std::span<const AngleSweep> replicas);

}  // namespace crossgrain::measure
