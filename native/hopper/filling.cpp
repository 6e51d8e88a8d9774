#include "native/hopper/filling.hpp"

#include "native/hopper/initial_state.hpp"

#include <algorithm>

namespace crossgrain::hopper {
namespace {

Geometry checked_geometry(const Parameters& p) {
    check(p);
    return {p.outlet, p.levels, p.angle};
}

}  // namespace

Filling::Filling(const Parameters& parameters)
    : geometry(checked_geometry(parameters)), field(geometry.empty_field()) {
    const auto initial = initial_state(parameters, geometry.sites());
    for (std::size_t k = 0; k < geometry.levels().size(); ++k) {
        const Level& level = geometry.levels()[k];
        std::copy_n(initial.begin() + static_cast<std::ptrdiff_t>(level.offset), level.sites(),
                    field.begin() + static_cast<std::ptrdiff_t>(geometry.place_of_level(k)));
    }
}

void Filling::empty_outlet() {
    const std::size_t start = geometry.place_of_level(0);
    std::uint32_t left = 0;
    for (std::size_t i = 0; i < geometry.levels()[0].sites(); ++i) {
        left += field[start + i] != 0;
        field[start + i] = 0;
    }
    record.flow.push_back(left);
    note_reach(0);
}

void Filling::note_reach(std::size_t k) {
    const std::size_t first = geometry.place_of_level(k);
    const std::size_t last = first + geometry.levels()[k].sites() - 1;
    const auto level = static_cast<std::int32_t>(k);
    if (field[first] == 0) record.left_reach = std::max(record.left_reach, level);
    if (field[last] == 0) record.right_reach = std::max(record.right_reach, level);
}

std::vector<std::uint8_t> Filling::sites() const {
    std::vector<std::uint8_t> state(geometry.sites());
    for (std::size_t k = 0; k < geometry.levels().size(); ++k) {
        const Level& level = geometry.levels()[k];
        std::copy_n(field.begin() + static_cast<std::ptrdiff_t>(geometry.place_of_level(k)),
                    level.sites(), state.begin() + static_cast<std::ptrdiff_t>(level.offset));
    }
    return state;
}

}  // namespace crossgrain::hopper
