#include "cases/measure/gas/wave_numbers.hpp"

#include "cases/measure/statistics/power_law.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <algorithm>
#include <utility>

namespace crossgrain::measure {

Series wave_number_series(std::span<const std::vector<double>> samples) {
    Series series{.name = "wave-numbers", .columns = {"k", "S", "err"}, .values = {{}, {}, {}}};
    std::vector<double> own(samples.size());
    for (std::size_t k = 1; k < samples.front().size(); ++k) {
        for (std::size_t i = 0; i < samples.size(); ++i)
            own[i] = samples[i][k];
        const numerics::MeanWithError s = numerics::mean_with_error(own);
        series.values[0].push_back(static_cast<double>(k));
        series.values[1].push_back(s.value);
        series.values[2].push_back(s.standard_error);
    }
    return series;
}

void append_wave_number_exponent(std::span<const std::vector<double>> samples, int k_min, int k_max,
                                 Results& results) {
    const auto slope = slope_of_mean(samples, k_min, k_max);
    if (!slope) return;
    double least = slope->value, most = slope->value;
    for (const auto& [low, high] : {std::pair{k_min, k_max / 2}, std::pair{2 * k_min, k_max}}) {
        const auto other = log_log_slope(mean_spectrum(samples), low, high);
        if (!other) continue;
        least = std::min(least, *other);
        most = std::max(most, *other);
    }
    results.measurements.push_back({.observable = "wave_number_exponent",
                                    .value = slope->value,
                                    .standard_error = slope->standard_error,
                                    .systematic = (most - least) / 2,
                                    .n = samples.size(),
                                    .settings = {{"k_min", static_cast<double>(k_min)},
                                                 {"k_max", static_cast<double>(k_max)}}});
}

}  // namespace crossgrain::measure
