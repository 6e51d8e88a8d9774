#include "cases/measure/statistics/time_mean.hpp"

#include "cases/measure/statistics/autocorrelation.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace crossgrain::measure {
namespace {

std::optional<BlockedMean> mean_of_series(std::span<const double> series) {
    auto mean = blocked_mean(series);
    const auto correlated = autocorrelated_mean(series);
    if (mean && correlated && correlated->standard_error > mean->standard_error) {
        mean->standard_error = correlated->standard_error;
        mean->blocks = std::min(mean->blocks, static_cast<std::size_t>(correlated->independent));
    }
    return mean;
}

}  // namespace

std::optional<BlockedMean> time_mean(std::span<const double> times, std::span<const double> values,
                                     double skip, std::optional<double> period) {
    const auto first =
        static_cast<std::size_t>(std::ranges::lower_bound(times, skip) - times.begin());
    times = times.subspan(first);
    values = values.subspan(first);
    if (!period || times.size() < 2) return mean_of_series(values);

    const double interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    // Sample times are rounded: the first one of a period may come a little early.
    const double early = 1e-6 * interval;
    const auto period_of = [&](double time) {
        return std::floor((time - times.front() + early) / *period);
    };
    std::vector<double> means;
    for (std::size_t begin = 0, i = 1; i <= times.size(); ++i) {
        const double next = i < times.size() ? times[i] : times.back() + interval;
        if (period_of(next) == period_of(times[begin])) continue;
        means.push_back(numerics::mean_with_error(values.subspan(begin, i - begin)).value);
        begin = i;
    }
    return mean_of_series(means);
}

}  // namespace crossgrain::measure
