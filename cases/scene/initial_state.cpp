#include "cases/scene/initial_state.hpp"

#include "cases/scene/initial_draws.hpp"
#include "cases/scene/initial_recipes.hpp"
#include "cases/scene/limits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace crossgrain::scene {
namespace {

void generate(Scene& scene, const Bounces& bounces, const SizeSpread&) {
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

void generate(Scene& scene, const Gas& gas, const SizeSpread& sizes) {
    if (!scene.periodic_x || !scene.periodic_y) {
        throw std::invalid_argument("a gas needs periodic_x and periodic_y");
    }
    const auto side =
        static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(gas.count))));
    const double sx = *scene.periodic_x / static_cast<double>(side);
    const double sy = *scene.periodic_y / static_cast<double>(side);
    const double free = std::min(sx, sy) - scene.grains.diameter * (1 + sizes.spread);
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
    draw_spins(scene, gas.spin_spread);
    draw_sizes(scene, sizes);
}

void generate(Scene& scene, const Lattice& lattice, const SizeSpread& sizes) {
    if (!scene.periodic_x || !scene.plates.bottom) {
        throw std::invalid_argument("a lattice needs periodic_x and a bottom plate");
    }
    const double spacing = *scene.periodic_x / static_cast<double>(lattice.columns);
    const double free = spacing - scene.grains.diameter * (1 + sizes.spread);
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
    draw_sizes(scene, sizes);
}

void generate(Scene& scene, const Packing& packing, const SizeSpread& sizes) {
    if (!scene.periodic_x || !scene.plates.bottom) {
        throw std::invalid_argument("a packing needs periodic_x and a bottom plate");
    }
    if (sizes.spread > 0) throw std::invalid_argument("a packing needs grains that are alike");
    const double d = scene.grains.diameter;
    // The period is a decimal number; only its rounding is forgiven.
    const double fit = std::floor(*scene.periodic_x / d * (1 + 1e-12));
    const std::size_t columns = grains_for(fit, "a row");
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

void generate(Scene& scene, const Explicit& given, const SizeSpread&) {
    scene.initial = given.state;
    scene.grains.diameters = given.diameters;
    scene.grains.masses = given.masses;
}

/// Draws and sums may have overflowed, whatever the input was.
void check_extent(const Scene& scene) {
    const auto& s = scene.initial;
    const double most = farthest * scene.grains.diameter;
    for (std::size_t i = 0; i < scene.grain_count(); ++i) {
        const double distance = std::max(std::abs(s.x[i]), std::abs(s.y[i]));
        const double omega = s.omega.empty() ? 0.0 : s.omega[i];
        if (!(distance <= most)) {
            throw std::invalid_argument(
                fmt::format("grain {} is {:.3g} diameters from the origin, farther than {:g}", i,
                            distance / scene.grains.diameter, farthest));
        }
        if (!std::isfinite(s.vx[i]) || !std::isfinite(s.vy[i]) || !std::isfinite(omega)) {
            throw std::invalid_argument(fmt::format("the velocity of grain {} is not finite", i));
        }
        const double mass = scene.grains.mass_of(i);
        if (!std::isfinite(mass) || mass <= 0) {
            throw std::invalid_argument(fmt::format("the mass of grain {} is {}", i, mass));
        }
    }
}

void check_frozen(const InitialState& s) {
    for (std::size_t i = 0; i < s.frozen.size(); ++i) {
        const bool spins = !s.omega.empty() && s.omega[i] != 0;
        if (s.frozen[i] && (s.vx[i] != 0 || s.vy[i] != 0 || spins)) {
            throw std::invalid_argument(fmt::format("grain {} is frozen but has a velocity", i));
        }
    }
}

}  // namespace

void generate_initial_state(Scene& scene, const InitialStateRecipe& recipe,
                            const SizeSpread& sizes) {
    std::visit([&](const auto& r) { generate(scene, r, sizes); }, recipe);
    check_extent(scene);
    check_frozen(scene.initial);
    if (!scene.initial.omega.empty() && !scene.has_friction()) {
        throw std::invalid_argument("grains spin, but without friction nothing feels it");
    }
    if (const std::size_t contacts = initial_contacts(scene); contacts > 0) {
        throw std::invalid_argument(
            fmt::format("{} contacts at the start: codes would start them differently", contacts));
    }
}

}  // namespace crossgrain::scene
