#include "cases/measure/hopper/hopper_replicas.hpp"

#include "native/numerics/mean_with_error.hpp"

#include <cmath>

namespace crossgrain::measure {

void append_replica_mean(Results& results, const std::string& observable,
                         std::span<const double> samples, const std::string& unit,
                         const std::map<std::string, double>& settings) {
    if (samples.size() < 2) return;
    const numerics::MeanWithError mean = numerics::mean_with_error(samples);
    results.measurements.push_back({.observable = observable,
                                    .value = mean.value,
                                    .standard_error = mean.standard_error,
                                    .n = mean.n,
                                    .unit = unit,
                                    .settings = settings});
}

void append_share(Results& results, const std::string& observable, std::size_t holds,
                  std::size_t replicas, const std::map<std::string, double>& settings) {
    if (replicas == 0) return;
    const double n = static_cast<double>(replicas);
    const double guarded = (static_cast<double>(holds) + 1) / (n + 2);
    results.measurements.push_back({.observable = observable,
                                    .value = static_cast<double>(holds) / n,
                                    .standard_error = std::sqrt(guarded * (1 - guarded) / (n + 2)),
                                    .n = replicas,
                                    .settings = settings});
}

}  // namespace crossgrain::measure
