// The "Parzen" window of Numerical Recipes (1988), section 12.7, nowadays Bartlett's.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace crossgrain::measure {

/// w_j = 1 - |(j - (M-1)/2)/((M+1)/2)| for j = 0..M-1, a triangle.
[[nodiscard]] inline std::vector<float> parzen_window(std::size_t points) {
    const auto m = static_cast<double>(points);
    std::vector<float> window(points);
    for (std::size_t j = 0; j < points; ++j) {
        window[j] = static_cast<float>(
            1 - std::abs((static_cast<double>(j) - (m - 1) / 2) / ((m + 1) / 2)));
    }
    return window;
}

}  // namespace crossgrain::measure
