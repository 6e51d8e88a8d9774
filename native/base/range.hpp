// An interval of valid numbers, with its text for error lines.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace crossgrain {

/// Finite numbers from `low` to `high`; an end that is open does not belong to it.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;
    bool high_open = false;
    std::string text = "a finite number";  ///< e.g. "a number > 0"

    static Range any();
    static Range positive();
    static Range not_negative();
    static Range at_least(double low);
    static Range open(double low, double high);        ///< low < value < high
    static Range left_open(double low, double high);   ///< low < value <= high
    static Range right_open(double low, double high);  ///< low <= value < high
    /// Whole numbers, both ends included; exact in a double up to 2^53.
    static Range whole(std::int64_t least, std::int64_t most = 1'000'000'000);
    [[nodiscard]] bool holds(double value) const;
};

}  // namespace crossgrain
