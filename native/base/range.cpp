#include "native/base/range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace crossgrain {

Range Range::any() {
    return {};
}
Range Range::positive() {
    return {.low = 0, .low_open = true, .text = "a number > 0"};
}
Range Range::not_negative() {
    return {.low = 0, .text = "a number >= 0"};
}
Range Range::at_least(double low) {
    return {.low = low, .text = fmt::format("a number >= {:g}", low)};
}
Range Range::open(double low, double high) {
    return {low, high, true, true, fmt::format("a number in ({:g}, {:g})", low, high)};
}
Range Range::left_open(double low, double high) {
    return {low, high, true, false, fmt::format("a number in ({:g}, {:g}]", low, high)};
}
Range Range::right_open(double low, double high) {
    return {low, high, false, true, fmt::format("a number in [{:g}, {:g})", low, high)};
}
Range Range::whole(std::int64_t least, std::int64_t most) {
    return {.low = static_cast<double>(least),
            .high = static_cast<double>(most),
            .text = fmt::format("an integer from {} to {}", least, most)};
}

bool Range::holds(double value) const {
    return std::isfinite(value) && (low_open ? value > low : value >= low) &&
           (high_open ? value < high : value <= high);
}

}  // namespace crossgrain
