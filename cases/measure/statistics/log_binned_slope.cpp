#include "cases/measure/statistics/log_binned_slope.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace crossgrain::measure {
namespace {

struct Bin {
    double x = 0, y = 0;  ///< sums, then means, of log f and log P
    double n = 0;
};

double slope_of(const std::vector<Bin>& bins) {
    double x = 0, y = 0, xx = 0, xy = 0;
    const auto n = static_cast<double>(bins.size());
    for (const Bin& bin : bins) {
        x += bin.x / n;
        y += bin.y / n;
    }
    for (const Bin& bin : bins) {
        xx += (bin.x - x) * (bin.x - x);
        xy += (bin.x - x) * (bin.y - y);
    }
    return xy / xx;
}

}  // namespace

std::optional<double> log_binned_slope(std::span<const double> power, std::size_t points,
                                       FrequencyWindow window) {
    const auto n = static_cast<double>(points);
    // A frequency on the window's edge is inside, whatever its last bit.
    const auto first = static_cast<std::size_t>(std::ceil(window.low * n * (1 - 1e-12)));
    const auto last = static_cast<std::size_t>(std::floor(window.high * n * (1 + 1e-12)));
    std::vector<Bin> bins;
    std::ptrdiff_t present = -1;
    for (std::size_t k = std::max<std::size_t>(first, 1); k <= last && k < power.size(); ++k) {
        if (!(power[k] > 0)) return std::nullopt;
        const double f = static_cast<double>(k) / n;
        const auto index = static_cast<std::ptrdiff_t>(
            std::floor(bins_per_decade * std::log10(std::max(f / window.low, 1.0))));
        if (index != present) bins.emplace_back();
        present = index;
        bins.back().x += std::log(f);
        bins.back().y += std::log(power[k]);
        bins.back().n += 1;
    }
    if (bins.size() < 3) return std::nullopt;
    for (Bin& bin : bins) {
        bin.x /= bin.n;
        bin.y /= bin.n;
    }
    return slope_of(bins);
}

}  // namespace crossgrain::measure
