#include "cases/scene/initial_draws.hpp"
#include "cases/scene/initial_recipes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace crossgrain::scene {
namespace {

/// A jittered lattice of columns and rows that fills [left, right] x [0, height).
struct Sites {
    double left, right, height;
    std::size_t columns, rows;

    [[nodiscard]] std::size_t count() const { return columns * rows; }
    [[nodiscard]] double dx() const { return (right - left) / static_cast<double>(columns); }
    [[nodiscard]] double dy() const { return height / static_cast<double>(rows); }
    [[nodiscard]] double x(std::size_t k) const {
        return left + dx() * (static_cast<double>(k % columns) + 0.5);
    }
    [[nodiscard]] double y(std::size_t k) const {
        return dy() * (static_cast<double>(k / columns) + 0.5);
    }
};

/// Cells that are as square as can be.
Sites sites_for(std::size_t count, double left, double right, double height) {
    const double cell = std::sqrt((right - left) * height / static_cast<double>(count));
    const auto columns = static_cast<std::size_t>(std::max(1.0, std::round((right - left) / cell)));
    return {.left = left,
            .right = right,
            .height = height,
            .columns = columns,
            .rows = (count + columns - 1) / columns};
}

void place_grains(Scene& scene, const Pipe& pipe, double largest) {
    const double d = scene.grains.diameter;
    const double length = *scene.periodic_y;
    const double area = (pipe.width - d) * length;
    const std::size_t count = grains_for(
        std::round(pipe.area_fraction * area / (std::numbers::pi / 4 * d * d)), "the filling");
    if (count == 0) throw std::invalid_argument("the area fraction leaves no grain");
    // Centres stay a touch away from the frozen discs.
    const double reach = (d + largest) / 2;
    // A grain's cell must hold it with its jitter; half of that room is beyond the last centres.
    const Sites sites =
        sites_for(count, reach - largest / 2, pipe.width - reach + largest / 2, length);
    const double free = std::min(sites.dx(), sites.dy()) - largest;
    if (free <= 0) {
        throw std::invalid_argument(
            fmt::format("an area fraction of {:g} does not fit a lattice between the walls",
                        pipe.area_fraction));
    }
    resize(scene.initial, count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t site = i * sites.count() / count;
        scene.initial.x[i] = sites.x(site);
        scene.initial.y[i] = sites.y(site);
        jitter(scene, i, 0.45 * free);
    }
    thermalise(scene, pipe.velocity_spread);
    for (double& vy : scene.initial.vy)
        vy -= pipe.fall_speed;
}

void add_walls(Scene& scene, const Pipe& pipe) {
    const double length = *scene.periodic_y;
    const double count = std::round(length / pipe.wall_spacing);
    if (count < 1) throw std::invalid_argument("the wall's spacing is longer than the pipe");
    const double spacing = length / count;
    (void)grains_for(2 * count, "the walls");
    for (const bool right : {false, true}) {
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
            const double y = spacing * (static_cast<double>(k) + (right ? 0.5 : 0.0));
            add_frozen(scene, right ? pipe.width : 0.0, y);
        }
    }
}

}  // namespace

void generate(Scene& scene, const Pipe& pipe, const SizeSpread& sizes) {
    if (!scene.periodic_y || scene.periodic_x) {
        throw std::invalid_argument("a pipe needs periodic_y and no periodic_x");
    }
    if (pipe.width <= 2 * scene.grains.diameter) {
        throw std::invalid_argument("the pipe is too narrow for a grain between its walls");
    }
    place_grains(scene, pipe, scene.grains.diameter * (1 + sizes.spread));
    draw_sizes(scene, sizes);
    if (!pipe.smooth) add_walls(scene, pipe);
}

}  // namespace crossgrain::scene
