// Median of a sample.
#pragma once

#include <vector>

namespace crossgrain::numerics {

/// The middle value; of an even number of values the upper one of the two in the middle, so that
/// the median is always a value of the sample. Throws std::invalid_argument for no values.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace crossgrain::numerics
