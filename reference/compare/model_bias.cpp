#include "reference/compare/model_bias.hpp"

#include "native/numerics/mean_with_error.hpp"
#include "reference/compare/student.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace crossgrain::compare {

ModelBias model_bias(std::span<const ModelComparison> comparisons) {
    if (comparisons.size() < 2) {
        throw std::invalid_argument("a bias with a deviation needs two comparisons or more");
    }
    const auto n = static_cast<double>(comparisons.size());
    std::vector<double> y;
    double reference_variance = 0, statistical_variance = 0;
    for (const auto& c : comparisons) {
        const double ratio = c.model / c.reference;
        if (!(std::isfinite(ratio) && ratio > 0)) {
            throw std::invalid_argument(
                fmt::format("no logarithm of the ratio of {} and {}", c.model, c.reference));
        }
        y.push_back(std::log(ratio));
        reference_variance += c.reference_relative_error * c.reference_relative_error / n;
        statistical_variance += c.model_relative_error * c.model_relative_error / n;
    }
    const auto mean = numerics::mean_with_error(y);
    const double variance = mean.standard_error * mean.standard_error * n;
    const double of_model = std::max(0.0, variance - reference_variance - statistical_variance);
    const double centre = mean.value + (of_model - reference_variance) / 2;
    const double half = student_quantile(0.975, n - 1) * mean.standard_error;
    return {.bias = std::exp(centre),
            .relative_deviation = std::sqrt(of_model),
            .bias_low = std::exp(centre - half),
            .bias_high = std::exp(centre + half),
            .reference_relative_error = std::sqrt(reference_variance),
            .comparisons = comparisons.size()};
}

}  // namespace crossgrain::compare
