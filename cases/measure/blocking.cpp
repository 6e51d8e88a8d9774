#include "cases/measure/blocking.hpp"

#include "cases/measure/mean_with_error.hpp"

#include <vector>

namespace crossgrain::measure {

std::optional<BlockedMean> blocked_mean(std::span<const double> series) {
    constexpr std::size_t fewest_blocks = 8;
    if (series.size() < fewest_blocks) return std::nullopt;
    const MeanWithError naive = mean_with_error(series);
    if (naive.standard_error == 0) return BlockedMean{naive.value, 0.0, naive.n};

    const auto n = static_cast<double>(series.size());
    std::vector<double> blocks(series.begin(), series.end());
    for (double length = 1; blocks.size() >= fewest_blocks; length *= 2) {
        const MeanWithError blocked = mean_with_error(blocks);
        const double inflation = blocked.standard_error / naive.standard_error;
        const double fourth_power = inflation * inflation * inflation * inflation;
        if (length * length * length > 2 * n * fourth_power) {
            return BlockedMean{naive.value, blocked.standard_error, blocks.size()};
        }
        // An odd last block is left out of the error, not of the mean.
        for (std::size_t i = 0; i + 1 < blocks.size(); i += 2) {
            blocks[i / 2] = (blocks[i] + blocks[i + 1]) / 2;
        }
        blocks.resize(blocks.size() / 2);
    }
    return std::nullopt;
}

}  // namespace crossgrain::measure
