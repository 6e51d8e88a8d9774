#include "cases/measure/statistics/log_binned_slope.hpp"

#include "native/numerics/line_fit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace crossgrain::measure {
namespace {

struct Bin {
    double x = 0, y = 0;  ///< sums of log f and log P
    double n = 0;
};

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
        if (!(power[k] > 0) || !std::isfinite(power[k])) return std::nullopt;
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
    std::vector<double> x, y;
    for (const Bin& bin : bins) {
        x.push_back(bin.x / bin.n);
        y.push_back(bin.y / bin.n);
    }
    return numerics::line_through(x, y).slope;
}

}  // namespace crossgrain::measure
