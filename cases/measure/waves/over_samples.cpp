#include "cases/measure/waves/over_samples.hpp"

#include "native/numerics/mean_with_error.hpp"

#include <cmath>

namespace crossgrain::measure {

Measurement fraction(const std::string& observable, std::size_t holding, std::size_t samples) {
    const auto n = static_cast<double>(samples);
    const double share = static_cast<double>(holding) / n;
    return {.observable = observable,
            .value = share,
            .standard_error = std::sqrt(share * (1 - share) / n),
            .n = samples};
}

Measurement over_samples(const std::string& observable, std::span<const double> values,
                         const std::string& unit) {
    const numerics::MeanWithError mean = numerics::mean_with_error(values);
    return {.observable = observable,
            .value = mean.value,
            .standard_error = mean.standard_error,
            .n = mean.n,
            .unit = unit};
}

}  // namespace crossgrain::measure
