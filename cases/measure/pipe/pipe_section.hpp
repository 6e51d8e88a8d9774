// What the observables of grains in a vertical pipe have to know of their scene: its length, its
// clear width, which grains move, and how much of the pipe these fill.
#pragma once

#include "cases/scene/scene.hpp"

#include <cstddef>
#include <vector>

namespace crossgrain::measure {

struct PipeSection {
    double length = 0;                ///< L, the period along gravity (l)
    double clear_width = 0;           ///< W, between the surfaces of the walls (l)
    double diameter = 0;              ///< nominal one of the grains (l)
    double area_fraction = 0;         ///< of the mobile grains in L W
    double interval = 0;              ///< T, time between frames (t)
    std::vector<std::size_t> mobile;  ///< grains that are not frozen

    /// Distance down the pipe of a height y, in [0, L).
    [[nodiscard]] double down(double y) const;
};

/// The walls are the left and the right column of frozen grains; without frozen grains the
/// backing planes, on which grains lie with their centres; without these the period along x.
/// Throws std::invalid_argument for a scene that is no such pipe: open along y, without walls, or
/// without mobile grains.
[[nodiscard]] PipeSection pipe_section(const scene::Scene& scene);

}  // namespace crossgrain::measure
