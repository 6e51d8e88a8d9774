#include "cases/scene/initial_state.hpp"

#include "native/base/random.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace crossgrain::scene {
namespace {

void resize(InitialState& s, std::size_t n) {
    s.x.assign(n, 0);
    s.y.assign(n, 0);
    s.vx.assign(n, 0);
    s.vy.assign(n, 0);
}

/// Isolated objects sit on a square grid, far enough apart that they never meet, close enough to
/// the origin that positions keep their digits.
struct Grid {
    std::size_t columns;
    double spacing;
    [[nodiscard]] double x(std::size_t k) const {
        return spacing * static_cast<double>(k % columns);
    }
    [[nodiscard]] double y(std::size_t k) const {
        return spacing * static_cast<double>(k / columns);
    }
};

Grid grid_for(std::size_t count, double spacing) {
    return {static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count)))), spacing};
}

/// Distance that an approach at `speed` covers until object k of `count` touches.
double gap_of(std::size_t k, std::size_t count, double lead_steps, double speed, double dt) {
    const double phase = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    return (lead_steps + phase) * speed * dt;
}

void generate(Scene& scene, const Pairs& pairs) {
    auto& s = scene.initial;
    const double d = scene.grains.diameter;
    const double b = pairs.impact_parameter;
    if (std::abs(b) >= d) {
        throw std::invalid_argument(
            fmt::format("impact parameter {:g}: grains of diameter {:g} would not meet", b, d));
    }
    // Free flight after the collision is the rest of the run at no more than the approach speed.
    const double travel = pairs.approach_speed * scene.dt * static_cast<double>(scene.steps);
    const Grid grid = grid_for(pairs.count, 3 * d + 2 * travel);
    const double touch = std::sqrt(d * d - b * b);
    resize(s, 2 * pairs.count);
    if (pairs.frozen_partner) s.frozen.assign(2 * pairs.count, false);
    for (std::size_t k = 0; k < pairs.count; ++k) {
        const double gap = gap_of(k, pairs.count, pairs.lead_steps, pairs.approach_speed, scene.dt);
        const std::size_t left = 2 * k;
        const std::size_t right = left + 1;
        s.x[left] = grid.x(k);
        s.y[left] = grid.y(k);
        s.x[right] = grid.x(k) + touch + gap;
        s.y[right] = grid.y(k) + b;
        s.vx[left] = pairs.frozen_partner ? pairs.approach_speed : pairs.approach_speed / 2;
        s.vx[right] = pairs.frozen_partner ? 0 : -pairs.approach_speed / 2;
        if (pairs.frozen_partner) s.frozen[right] = true;
    }
}

void generate(Scene& scene, const Bounces& bounces) {
    auto& s = scene.initial;
    const double d = scene.grains.diameter;
    const double reach = scene.plates.touches == PlateContact::surface ? d / 2 : 0.0;
    const double side = bounces.target == Target::bottom ? 1.0 : -1.0;
    double plate = 0;
    if (bounces.target == Target::bottom) {
        if (!scene.plates.bottom) throw std::invalid_argument("there is no bottom plate");
        plate = height_at(*scene.plates.bottom, 0);
    } else if (const auto* lid = std::get_if<FreeLid>(&scene.plates.lid)) {
        // Grains share the lid: a second one would meet a lid that has already moved.
        if (bounces.count != 1)
            throw std::invalid_argument("one grain only can bounce on a free lid");
        plate = lid->height;
    } else {
        throw std::invalid_argument("there is no free lid");
    }
    resize(s, bounces.count);
    for (std::size_t k = 0; k < bounces.count; ++k) {
        const double gap = gap_of(k, bounces.count, bounces.lead_steps, bounces.speed, scene.dt);
        s.x[k] = 3 * d * static_cast<double>(k);
        s.y[k] = plate + side * (reach + gap);
        s.vy[k] = -side * bounces.speed;
    }
}

void remove_drift(std::vector<double>& v) {
    double mean = 0;
    for (const double value : v)
        mean += value;
    mean /= static_cast<double>(v.size());
    for (double& value : v)
        value -= mean;
}

void thermalise(Scene& scene, double spread) {
    auto& s = scene.initial;
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        const auto [gx, gy] = normal_pair(scene.seed, RandomStream::initial_velocity, i);
        s.vx[i] = spread * gx;
        s.vy[i] = spread * gy;
    }
    remove_drift(s.vx);
    remove_drift(s.vy);
}

/// Moves grain i by less than `reach` in a random direction.
void jitter(Scene& scene, std::size_t i, double reach) {
    const double angle =
        2 * std::numbers::pi * uniform(scene.seed, RandomStream::initial_position, i);
    const double radius = reach * uniform(scene.seed, RandomStream::jitter, i);
    scene.initial.x[i] += radius * std::cos(angle);
    scene.initial.y[i] += radius * std::sin(angle);
}

void generate(Scene& scene, const Gas& gas) {
    if (!scene.periodic_x || !scene.periodic_y) {
        throw std::invalid_argument("a gas needs periodic_x and periodic_y");
    }
    const auto side =
        static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(gas.count))));
    const double sx = *scene.periodic_x / static_cast<double>(side);
    const double sy = *scene.periodic_y / static_cast<double>(side);
    const double free = std::min(sx, sy) - scene.grains.diameter;
    if (free <= 0) {
        throw std::invalid_argument(fmt::format("{} grains of diameter {:g} do not fit the box",
                                                gas.count, scene.grains.diameter));
    }
    resize(scene.initial, gas.count);
    for (std::size_t i = 0; i < gas.count; ++i) {
        scene.initial.x[i] = sx * (static_cast<double>(i % side) + 0.5);
        scene.initial.y[i] = sy * (static_cast<double>(i / side) + 0.5);
        jitter(scene, i, 0.45 * free);
    }
    thermalise(scene, gas.velocity_spread);
}

void generate(Scene& scene, const Lattice& lattice) {
    if (!scene.periodic_x || !scene.plates.bottom) {
        throw std::invalid_argument("a lattice needs periodic_x and a bottom plate");
    }
    const double spacing = *scene.periodic_x / static_cast<double>(lattice.columns);
    const double free = spacing - scene.grains.diameter;
    if (free <= 0) {
        throw std::invalid_argument(
            fmt::format("{} columns of grains of diameter {:g} do not fit the period {:g}",
                        lattice.columns, scene.grains.diameter, *scene.periodic_x));
    }
    const double reach =
        scene.plates.touches == PlateContact::surface ? scene.grains.diameter / 2 : 0.0;
    const double lowest = height_at(*scene.plates.bottom, 0) + reach + free;
    resize(scene.initial, lattice.count);
    double highest = lowest;
    for (std::size_t i = 0; i < lattice.count; ++i) {
        const std::size_t row = i / lattice.columns;
        const double offset = row % 2 == 0 ? 0.25 : 0.75;
        scene.initial.x[i] = spacing * (static_cast<double>(i % lattice.columns) + offset);
        scene.initial.y[i] = lowest + spacing * std::numbers::sqrt3 / 2 * static_cast<double>(row);
        jitter(scene, i, 0.45 * free);
        highest = std::max(highest, scene.initial.y[i]);
    }
    if (auto* lid = std::get_if<FreeLid>(&scene.plates.lid)) {
        lid->height = highest + reach + lattice.lid_gap;
    }
    thermalise(scene, lattice.velocity_spread);
}

void generate(Scene& scene, const Packing& packing) {
    if (!scene.periodic_x || !scene.plates.bottom) {
        throw std::invalid_argument("a packing needs periodic_x and a bottom plate");
    }
    const double d = scene.grains.diameter;
    // The period is a decimal number; only its rounding is forgiven.
    const double fit = std::floor(*scene.periodic_x / d * (1 + 1e-12));
    const auto columns = static_cast<std::size_t>(fit);
    if (columns == 0 || packing.count % columns != 0) {
        throw std::invalid_argument(fmt::format(
            "{} grains do not fill rows of {}: choose a multiple", packing.count, columns));
    }
    const double spacing = *scene.periodic_x / fit;
    // Longer by more than the rounding of heights, so that no pair touches at the start.
    const double bond = d * (1 + 1e-13);
    const double row_height = std::sqrt(bond * bond - spacing * spacing / 4);
    const double reach = scene.plates.touches == PlateContact::surface ? d / 2 : 0.0;
    const double lowest = height_at(*scene.plates.bottom, 0) + reach;
    resize(scene.initial, packing.count);
    for (std::size_t i = 0; i < packing.count; ++i) {
        const std::size_t row = i / columns;
        const double offset = row % 2 == 0 ? 0.25 : 0.75;
        scene.initial.x[i] = spacing * (static_cast<double>(i % columns) + offset);
        scene.initial.y[i] = lowest + row_height * static_cast<double>(row);
    }
    thermalise(scene, packing.velocity_spread);
}

void generate(Scene& scene, const Explicit& given) {
    scene.initial = given.state;
}

}  // namespace

void generate_initial_state(Scene& scene, const InitialStateRecipe& recipe) {
    std::visit([&](const auto& r) { generate(scene, r); }, recipe);
    for (std::size_t i = 0; i < scene.initial.frozen.size(); ++i) {
        if (scene.initial.frozen[i] && (scene.initial.vx[i] != 0 || scene.initial.vy[i] != 0)) {
            throw std::invalid_argument(fmt::format("grain {} is frozen but has a velocity", i));
        }
    }
    if (const std::size_t contacts = initial_contacts(scene); contacts > 0) {
        throw std::invalid_argument(
            fmt::format("{} contacts at the start: codes would start them differently", contacts));
    }
}

}  // namespace crossgrain::scene
