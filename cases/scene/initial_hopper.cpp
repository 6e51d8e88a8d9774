#include "cases/scene/initial_draws.hpp"
#include "cases/scene/initial_recipes.hpp"

#include "cases/scene/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace crossgrain::scene {
namespace {

/// The right-hand wall: its discs' centres lie on a line from the outlet's edge, at an angle from
/// the vertical. The left-hand one is its mirror image.
struct Wall {
    double edge;  ///< x of its lowest centre
    double sine, cosine;

    [[nodiscard]] double x_at(double y) const { return edge + y * sine / cosine; }
};

Wall wall_of(const Hopper& hopper, double d) {
    const double half_angle = hopper.angle / 2 * std::numbers::pi / 180;
    return {.edge = (hopper.outlet + d) / 2,
            .sine = std::sin(half_angle),
            .cosine = std::cos(half_angle)};
}

/// Grains that fill the trapezium between the walls up to the height.
std::size_t grains_in(const Hopper& hopper, const Wall& wall, double d) {
    const double mean_width = hopper.outlet + hopper.height * wall.sine / wall.cosine;
    const double area = mean_width * hopper.height;
    return grains_for(std::round(hopper.settled_fraction * area / (std::numbers::pi / 4 * d * d)),
                      "the filling");
}

/// Rows of a square lattice, from the plug upwards, each as wide as the walls leave it.
void place_grains(Scene& scene, const Hopper& hopper, const Wall& wall, double largest) {
    const double d = scene.grains.diameter;
    const std::size_t count = grains_in(hopper, wall, d);
    if (count == 0) throw std::invalid_argument("the hopper holds no grain");
    constexpr double looseness = 1.1;
    const double spacing = looseness * largest;
    const double free = spacing - largest;
    // Beside the wall a grain keeps the sum of the radii, and the jitter, from the discs' line.
    const double clearance = ((d + largest) / 2 + free / 2) / wall.cosine;
    auto& s = scene.initial;
    std::size_t placed = 0;
    resize(s, count);
    for (double y = (d + largest) / 2 + free; placed < count; y += spacing) {
        const double half_width = wall.x_at(y) - clearance;
        if (half_width < 0) throw std::invalid_argument("the outlet is too narrow for a grain");
        const std::size_t in_row =
            grains_for(std::floor(2 * half_width / spacing), "a row of the filling") + 1;
        const double first = -spacing * static_cast<double>(in_row - 1) / 2;
        for (std::size_t k = 0; k < in_row && placed < count; ++k, ++placed) {
            s.x[placed] = first + spacing * static_cast<double>(k);
            s.y[placed] = y;
            jitter(scene, placed, 0.45 * free);
        }
    }
    thermalise(scene, hopper.velocity_spread);
}

/// Discs from the outlet's edges to above the highest grain.
void add_walls(Scene& scene, const Wall& wall) {
    const double d = scene.grains.diameter;
    const double top = *std::max_element(scene.initial.y.begin(), scene.initial.y.end()) + 2 * d;
    const double rise = d * wall.cosine;
    (void)grains_for(2 * top / rise, "the walls");
    for (std::size_t k = 0; static_cast<double>(k) * rise <= top; ++k) {
        const double along = d * static_cast<double>(k);
        for (const double side : {-1.0, 1.0}) {
            add_frozen(scene, side * (wall.edge + along * wall.sine), along * wall.cosine);
        }
    }
}

/// The fewest discs that leave no gap between the outlet's edges.
void add_plug(Scene& scene, const Wall& wall) {
    const double d = scene.grains.diameter;
    const double gaps = std::ceil(2 * wall.edge / d * (1 - 1e-12));
    const double spacing = 2 * wall.edge / gaps;
    (void)grains_for(gaps, "the plug");
    for (double k = 1; k < gaps; ++k)
        add_frozen(scene, -wall.edge + k * spacing, 0);
}

}  // namespace

void generate(Scene& scene, const Hopper& hopper, const SizeSpread& sizes) {
    if (scene.periodic_x || scene.periodic_y) {
        throw std::invalid_argument("a hopper needs a scene without periods");
    }
    const Wall wall = wall_of(hopper, scene.grains.diameter);
    place_grains(scene, hopper, wall, scene.grains.diameter * (1 + sizes.spread));
    draw_sizes(scene, sizes);
    add_walls(scene, wall);
    add_plug(scene, wall);
}

void generate(Scene& scene, const Settled& settled, const SizeSpread& sizes) {
    generate(scene, settled.hopper, sizes);
    const double d = scene.grains.diameter;
    const double steps = std::round(settled.settle_time / scene.dt);
    if (steps > static_cast<double>(most_steps)) {
        throw std::invalid_argument(
            fmt::format("settling takes {:g} steps, more than {}", steps, most_steps));
    }
    Preparation preparation{.steps = std::max<std::int64_t>(1, static_cast<std::int64_t>(steps)),
                            .removed = std::vector<bool>(scene.grain_count(), false)};
    const double edge = wall_of(settled.hopper, d).edge;
    for (std::size_t i = 0; i < scene.grain_count(); ++i) {
        preparation.removed[i] = scene.initial.frozen[i] && scene.initial.y[i] == 0 &&
                                 std::abs(scene.initial.x[i]) < edge;
    }
    scene.preparation = std::move(preparation);
}

}  // namespace crossgrain::scene
