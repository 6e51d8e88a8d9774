// The hopper that frozen grains make: two straight, inclined walls, mirror images of each other,
// that leave an outlet between their lowest grains.
#pragma once

#include "cases/scene/scene.hpp"

#include <cstddef>
#include <vector>

namespace crossgrain::measure {

struct HopperWalls {
    double axis = 0;        ///< x of the middle (l)
    double level = 0;       ///< y of the lowest wall grains, the outlet (l)
    double outlet = 0;      ///< D, clear width between these (l)
    double half_width = 0;  ///< of the lines through the wall grains' centres at the outlet (l)
    double tangent = 0;     ///< of the half opening angle, tan(theta/2)
    double height = 0;      ///< of the walls above the outlet (l)
    double diameter = 0;    ///< nominal one of the grains (l)
    std::vector<std::size_t> mobile;

    /// Distance of a point from the nearer of the lines through the wall grains' centres, > 0
    /// between them (l).
    [[nodiscard]] double from_wall(double x, double y) const;
    /// Area between the walls from the outlet to the height h: D h + h^2 tan(theta/2).
    [[nodiscard]] double area_below(double h) const;
    /// Inverse of area_below.
    [[nodiscard]] double height_of(double area) const;
};

/// Throws std::invalid_argument for a scene without frozen or without mobile grains, with walls
/// that are not straight (a frozen grain a diameter off the line), that lean inward, or that leave
/// no outlet.
[[nodiscard]] HopperWalls hopper_walls(const scene::Scene& scene);

}  // namespace crossgrain::measure
