#include "cases/measure/hopper/hopper_stagnation_law.hpp"

#include "native/base/random.hpp"
#include "native/numerics/bootstrap.hpp"
#include "native/numerics/jackknife.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crossgrain::measure {
namespace {

constexpr double tolerance = 1e-9;  // of angles that are sums of steps

bool in_tangent(StagnationFit fit) {
    return fit == StagnationFit::tan_unweighted || fit == StagnationFit::tan_log;
}

bool of_logarithms(StagnationFit fit) {
    return fit == StagnationFit::log || fit == StagnationFit::tan_log;
}

/// Standard deviation of the statistic over sweeps whose angles are drawn with replacement.
std::optional<double> error_over_angles(const AngleSweep& sweep, std::uint64_t seed,
                                        const SweepStatistic& statistic) {
    constexpr std::size_t resamples = 100;
    const std::size_t angles = sweep.angles.size();
    return numerics::bootstrap_error(resamples, [&](std::size_t b) {
        AngleSweep drawn;
        for (std::size_t i = 0; i < angles; ++i) {
            const double u = uniform(seed, RandomStream::jitter, b * angles + i);
            const auto pick = static_cast<std::size_t>(u * static_cast<double>(angles));
            drawn.angles.push_back(sweep.angles[pick]);
            drawn.p.push_back(sweep.p[pick]);
        }
        return statistic(drawn);
    });
}

}  // namespace

std::string StagnationLaw::name() const {
    const char* fitted = of_logarithms(fit) ? "log" : "unweighted";
    return fmt::format("{}{}_{:g}_{:g}", in_tangent(fit) ? "tan_" : "", fitted, from, to);
}

std::vector<StagnationLaw> stagnation_laws() {
    std::vector<StagnationLaw> laws;
    for (const auto fit : {StagnationFit::unweighted, StagnationFit::log,
                           StagnationFit::tan_unweighted, StagnationFit::tan_log}) {
        for (const double from : {10.0, 13.0, 20.0, 30.0})
            laws.push_back({.fit = fit, .from = from, .to = 90});
    }
    return laws;
}

std::optional<PowerFit> fit_stagnation(const StagnationLaw& law, const AngleSweep& sweep) {
    constexpr std::size_t fewest = 10;
    constexpr double coverage = 1;
    std::vector<double> x, y;
    double lowest = 180, highest = 0;
    for (std::size_t i = 0; i < sweep.angles.size(); ++i) {
        const double theta = sweep.angles[i];
        if (theta < law.from - tolerance || theta > law.to + tolerance) continue;
        lowest = std::min(lowest, theta);
        highest = std::max(highest, theta);
        x.push_back(in_tangent(law.fit) ? std::tan(theta * std::numbers::pi / 360) : theta);
        y.push_back(1 / sweep.p[i]);
    }
    const bool covered = lowest <= law.from + coverage + tolerance &&
                         highest >= law.to - coverage - tolerance && x.size() >= fewest;
    if (!covered) return std::nullopt;
    return of_logarithms(law.fit) ? fit_logarithms(x, y) : fit_unweighted(x, y);
}

std::optional<double> end_of_mass_flow(const AngleSweep& sweep, double threshold) {
    constexpr std::size_t fewest = 3;
    constexpr double half_width = 0.5;  // degrees
    const std::size_t n = sweep.angles.size();
    if (n < fewest) return std::nullopt;
    const auto smooth = [&](double theta) {
        double sum = 0, weight = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (std::abs(sweep.angles[i] - theta) > half_width + tolerance) continue;
            sum += sweep.p[i];
            ++weight;
        }
        return sum / weight;
    };
    std::vector<double> angles = sweep.angles;
    std::ranges::sort(angles);
    double before = smooth(angles.front());
    if (before < threshold) return std::nullopt;
    for (std::size_t i = 1; i < n; ++i) {
        if (angles[i] - angles[i - 1] > 2 * half_width + tolerance) return std::nullopt;
        const double here = smooth(angles[i]);
        if (here < threshold) {
            const double share = (before - threshold) / (before - here);
            return angles[i - 1] + share * (angles[i] - angles[i - 1]);
        }
        before = here;
    }
    return std::nullopt;
}

AngleSweep mean_sweep(std::span<const AngleSweep> replicas) {
    AngleSweep mean{.angles = replicas.front().angles,
                    .p = std::vector<double>(replicas.front().p.size(), 0.0)};
    for (const AngleSweep& sweep : replicas) {
        for (std::size_t i = 0; i < mean.p.size(); ++i)
            mean.p[i] += sweep.p[i] / static_cast<double>(replicas.size());
    }
    return mean;
}

std::optional<SweepEstimate> over_replicas(std::span<const AngleSweep> replicas, std::uint64_t seed,
                                           const SweepStatistic& statistic) {
    constexpr std::size_t fewest_for_scatter = 4;
    const bool from_scatter = replicas.size() >= fewest_for_scatter;
    std::vector<double> values;
    double variance = 0;
    for (std::size_t r = 0; r < replicas.size(); ++r) {
        const auto value = statistic(replicas[r]);
        if (!value) return std::nullopt;
        values.push_back(*value);
        if (from_scatter) continue;
        const auto error = error_over_angles(replicas[r], seed + r, statistic);
        if (!error) return std::nullopt;
        variance += *error * *error;
    }
    const numerics::MeanWithError mean = numerics::mean_with_error(values);
    if (from_scatter) return SweepEstimate{mean.value, mean.standard_error, mean.n};
    return SweepEstimate{mean.value, std::sqrt(variance) / static_cast<double>(replicas.size()),
                         replicas.front().angles.size()};
}

std::optional<SweepEstimate> of_replica_mean(std::span<const AngleSweep> replicas,
                                             std::uint64_t seed, const SweepStatistic& statistic) {
    const AngleSweep mean = mean_sweep(replicas);
    const auto value = statistic(mean);
    if (!value) return std::nullopt;
    if (replicas.size() == 1) {
        const auto error = error_over_angles(mean, seed, statistic);
        if (!error) return std::nullopt;
        return SweepEstimate{*value, *error, mean.angles.size()};
    }
    std::vector<double> without_one;
    for (std::size_t left_out = 0; left_out < replicas.size(); ++left_out) {
        std::vector<AngleSweep> rest(replicas.begin(), replicas.end());
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
        const auto one = statistic(mean_sweep(rest));
        if (!one) return std::nullopt;
        without_one.push_back(*one);
    }
    return SweepEstimate{*value, numerics::jackknife_error(without_one), replicas.size()};
}

}  // namespace crossgrain::measure
