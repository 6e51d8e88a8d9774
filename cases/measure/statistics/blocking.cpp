#include "cases/measure/statistics/blocking.hpp"

#include "native/numerics/mean_with_error.hpp"

#include <vector>

namespace crossgrain::measure {
namespace {

constexpr std::size_t fewest_blocks = 16, batches = 6, fewest_values = 2 * batches;

// Error of the blocks of the first length that satisfies the criterion.
std::optional<numerics::MeanWithError> converged_blocks(std::span<const double> series,
                                                        const numerics::MeanWithError& naive) {
    const auto n = static_cast<double>(series.size());
    std::vector<double> blocks(series.begin(), series.end());
    for (double length = 1; blocks.size() >= fewest_blocks; length *= 2) {
        const numerics::MeanWithError blocked = numerics::mean_with_error(blocks);
        const double inflation = blocked.standard_error / naive.standard_error;
        const double fourth_power = inflation * inflation * inflation * inflation;
        if (length * length * length > 2 * n * fourth_power) return blocked;
        // An odd last block is left out of the error, not of the mean.
        for (std::size_t i = 0; i + 1 < blocks.size(); i += 2) {
            blocks[i / 2] = (blocks[i] + blocks[i + 1]) / 2;
        }
        blocks.resize(blocks.size() / 2);
    }
    return std::nullopt;
}

std::vector<double> means_of_parts(std::span<const double> series, std::size_t parts) {
    // What does not divide is left out of the error at the start of the series.
    const std::size_t length = series.size() / parts;
    const auto used = series.last(length * parts);
    std::vector<double> means;
    for (std::size_t b = 0; b < parts; ++b) {
        means.push_back(numerics::mean_with_error(used.subspan(b * length, length)).value);
    }
    return means;
}

std::optional<numerics::MeanWithError> batch_means(std::span<const double> series) {
    const std::vector<double> means = means_of_parts(series, batches);
    const numerics::MeanWithError error = numerics::mean_with_error(means);
    double squares = 0, successive = 0;
    for (std::size_t b = 0; b < batches; ++b) {
        squares += (means[b] - error.value) * (means[b] - error.value);
        if (b > 0) successive += (means[b] - means[b - 1]) * (means[b] - means[b - 1]);
    }
    constexpr double least_ratio = 0.6;  // independent batches fall below in 1.5 % of runs
    if (squares > 0 && successive < least_ratio * squares) return std::nullopt;
    return error;
}

}  // namespace

std::optional<BlockedMean> blocked_mean(std::span<const double> series) {
    if (series.size() < fewest_values) return std::nullopt;
    const numerics::MeanWithError naive = numerics::mean_with_error(series);
    if (naive.standard_error == 0) return BlockedMean{naive.value, 0.0, naive.n};
    auto error = converged_blocks(series, naive);
    if (!error) error = batch_means(series);
    if (!error) error = numerics::mean_with_error(means_of_parts(series, 2));
    return BlockedMean{naive.value, error->standard_error, error->n};
}

}  // namespace crossgrain::measure
