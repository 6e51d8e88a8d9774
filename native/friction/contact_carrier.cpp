#include "native/friction/contact_carrier.hpp"

#include <algorithm>

namespace crossgrain::friction {
namespace {

ContactMemory seen_from_the_other(const ContactMemory& m) {
    return {.x = -m.x, .y = -m.y, .nx = -m.nx, .ny = -m.ny};
}

}  // namespace

ContactCarrier::ContactCarrier(std::size_t grains) : first_(grains, none) {}

void ContactCarrier::clear() {
    std::fill(first_.begin(), first_.end(), none);
    kept_.clear();
}

void ContactCarrier::keep(std::uint32_t i, std::uint32_t j, const ContactMemory& memory) {
    auto& first = first_[std::min(i, j)];
    kept_.push_back({std::max(i, j), first, i < j ? memory : seen_from_the_other(memory)});
    first = static_cast<std::uint32_t>(kept_.size() - 1);
}

ContactMemory ContactCarrier::find(std::uint32_t i, std::uint32_t j) const {
    const std::uint32_t other = std::max(i, j);
    for (auto k = first_[std::min(i, j)]; k != none; k = kept_[k].next) {
        if (kept_[k].other != other) continue;
        return i < j ? kept_[k].memory : seen_from_the_other(kept_[k].memory);
    }
    return {};
}

}  // namespace crossgrain::friction
