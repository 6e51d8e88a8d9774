#include "native/hopper/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crossgrain::hopper {
namespace {

const double column_spacing = std::numbers::sqrt3 / 2;

double half_angle_tangent(double angle) {
    return std::tan(angle / 2 * std::numbers::pi / 180);
}

/// Sites of half-level k within |x| <= half_width, from first = -last to last.
Level level_within(double half_width, std::int32_t k, int outlet) {
    // Sites on the wall itself belong to the hopper, whatever the rounding of x.
    constexpr double on_the_wall = 1e-9;
    auto last = static_cast<std::int32_t>(std::floor((half_width + on_the_wall) / column_spacing));
    if ((last + k + outlet - 1) % 2 != 0) --last;
    return {.first = -last, .last = last};
}

}  // namespace

Geometry::Geometry(int outlet, int levels, double angle) {
    const double outlet_half_width = (outlet - 1) * column_spacing;
    const double tangent = half_angle_tangent(angle);
    const auto level_at = [&](std::int32_t k) {
        return level_within(outlet_half_width + std::max(k, 0) / 2.0 * tangent, k, outlet);
    };
    levels_.reserve(static_cast<std::size_t>(levels));
    for (std::int32_t k = 0; k < levels; ++k) {
        Level level = level_at(k);
        level.offset = sites_;
        sites_ += level.sites();
        levels_.push_back(level);
    }
    ghosts_ = {level_at(-2), level_at(-1), level_at(levels), level_at(levels + 1)};

    half_width_ = std::max(ghosts_[2].last, ghosts_[3].last) + 2;
    // (k, c) is a site where c + k + N - 1 is even: with an odd pitch its place is whole.
    if ((half_width_ - (outlet - 1)) % 2 != 0) ++half_width_;
    pitch_ = 2 * half_width_ + 3;
    steps_ = {0,
              0,
              (pitch_ - 1) / 2,
              pitch_,
              (pitch_ + 1) / 2,
              -(pitch_ - 1) / 2,
              -pitch_,
              -(pitch_ + 1) / 2};
}

std::size_t Geometry::stored() const noexcept {
    const auto half_levels = static_cast<std::int64_t>(levels_.size()) + 2 * margin;
    return static_cast<std::size_t>((half_levels + 1) * pitch_ / 2);
}

std::vector<std::uint8_t> Geometry::empty_field() const {
    std::vector<std::uint8_t> field(stored(), outside);
    const auto clear = [&](std::int32_t k, const Level& level) {
        if (level.last < level.first) return;
        std::fill_n(field.begin() + static_cast<std::ptrdiff_t>(place(k, level.first)),
                    level.sites(), std::uint8_t{0});
    };
    const auto count = static_cast<std::int32_t>(levels_.size());
    for (std::int32_t k = 0; k < count; ++k)
        clear(k, levels_[static_cast<std::size_t>(k)]);
    clear(-2, ghosts_[0]);
    clear(-1, ghosts_[1]);
    clear(count, ghosts_[2]);
    clear(count + 1, ghosts_[3]);
    return field;
}

double approximate_sites(int outlet, int levels, double angle) {
    // Half-widths of outlet and top; sites of a half-level are two columns apart.
    const double bottom = (outlet - 1) * column_spacing;
    const double top = bottom + levels / 2.0 * half_angle_tangent(angle);
    return levels * (bottom + top) / 2 / column_spacing;
}

}  // namespace crossgrain::hopper
