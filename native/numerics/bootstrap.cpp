#include "native/numerics/bootstrap.hpp"
#include "native/numerics/mean_with_error.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace crossgrain::numerics {

std::optional<double> bootstrap_error(std::size_t resamples, const ResampledStatistic& statistic) {
    if (resamples < 100) throw std::invalid_argument("a bootstrap needs 100 resamples or more");
    std::vector<double> values;
    for (std::size_t i = 0; i < resamples; ++i)
        if (const auto value = statistic(i)) values.push_back(*value);
    if (10 * values.size() < 9 * resamples) return std::nullopt;
    const MeanWithError spread = mean_with_error(values);
    return spread.standard_error * std::sqrt(static_cast<double>(values.size()));
}

}  // namespace crossgrain::numerics
