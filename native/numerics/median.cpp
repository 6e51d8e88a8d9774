#include "native/numerics/median.hpp"

#include <algorithm>
#include <stdexcept>

namespace crossgrain::numerics {

double median(std::vector<double> values) {
    if (values.empty()) throw std::invalid_argument("a median needs at least one value");
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

}  // namespace crossgrain::numerics
