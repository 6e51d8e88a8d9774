#include "adapters/run/store/picture_fault.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crossgrain::store {

std::optional<std::string> picture_fault(const measure::Picture& picture) {
    if (picture.pixels.empty() || picture.pixels.size() != picture.width * picture.height) {
        return fmt::format("has {} pixels for {} x {}", picture.pixels.size(), picture.width,
                           picture.height);
    }
    const std::size_t colours = picture.palette.size();
    if (colours > 256) return fmt::format("has {} colours, at most 256 are possible", colours);
    const auto highest = *std::max_element(picture.pixels.begin(), picture.pixels.end());
    if (highest >= colours)
        return fmt::format("uses colour {} of a palette of {}", highest, colours);
    return std::nullopt;
}

}  // namespace crossgrain::store
