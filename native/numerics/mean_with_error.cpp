#include "native/numerics/mean_with_error.hpp"

#include <cassert>
#include <cmath>

namespace crossgrain::numerics {

MeanWithError mean_with_error(std::span<const double> samples) {
    assert(!samples.empty());
    const auto n = static_cast<double>(samples.size());
    // Relative to the first sample: equal samples then have a mean without round-off.
    double sum = 0;
    for (const double sample : samples)
        sum += sample - samples.front();
    const double mean = samples.front() + sum / n;
    double squares = 0;
    for (const double sample : samples)
        squares += (sample - mean) * (sample - mean);
    const double error = samples.size() < 2 ? 0.0 : std::sqrt(squares / (n - 1) / n);
    return {mean, error, samples.size()};
}

}  // namespace crossgrain::numerics
