#include "cases/scene/initial_draws.hpp"
#include "cases/scene/initial_recipes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace crossgrain::scene {
namespace {

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

/// Every second grain is of another size.
void resize_partners(Scene& scene, const Pairs& pairs, double mass_exponent) {
    if (pairs.partner_size == 1) return;
    auto& grains = scene.grains;
    grains.diameters.assign(2 * pairs.count, grains.diameter);
    grains.masses.assign(2 * pairs.count, grains.mass);
    for (std::size_t i = 1; i < 2 * pairs.count; i += 2) {
        grains.diameters[i] = grains.diameter * pairs.partner_size;
        grains.masses[i] = mass_of(grains, pairs.partner_size, mass_exponent);
    }
}

void spin_pairs(InitialState& s, const Pairs& pairs) {
    if (pairs.spin.largest() == 0 && pairs.partner_spin.largest() == 0) return;
    s.omega.assign(2 * pairs.count, 0);
    for (std::size_t k = 0; k < pairs.count; ++k) {
        s.omega[2 * k] = pairs.spin.at(k, pairs.count);
        if (!pairs.frozen_partner) s.omega[2 * k + 1] = pairs.partner_spin.at(k, pairs.count);
    }
}

}  // namespace

void generate(Scene& scene, const Pairs& pairs, const SizeSpread& sizes) {
    auto& s = scene.initial;
    const double d = (scene.grains.diameter + scene.grains.diameter * pairs.partner_size) / 2;
    const double b = pairs.impact_parameter;
    if (std::abs(b) >= d) {
        throw std::invalid_argument(
            fmt::format("impact parameter {:g}: grains of diameter {:g} would not meet", b, d));
    }
    if (sizes.spread > 0) {
        throw std::invalid_argument("pairs differ by partner_size, not by diameter_spread");
    }
    // Free flight after the collision is the rest of the run at no more than this speed.
    const double fastest = pairs.approach_speed + pairs.tangential_speed.largest() +
                           d * (pairs.spin.largest() + pairs.partner_spin.largest());
    const double travel = fastest * scene.dt * static_cast<double>(scene.steps);
    const Grid grid = grid_for(pairs.count, 3 * d + 2 * travel);
    const double touch = std::sqrt(d * d - b * b);
    resize(s, 2 * pairs.count);
    if (pairs.frozen_partner) s.frozen.assign(2 * pairs.count, false);
    for (std::size_t k = 0; k < pairs.count; ++k) {
        const double gap = gap_of(k, pairs.count, pairs.lead_steps, pairs.approach_speed, scene.dt);
        const double slide = pairs.tangential_speed.at(k, pairs.count);
        if (touch * pairs.approach_speed + b * slide <= 0) {
            throw std::invalid_argument(fmt::format(
                "at the impact parameter {:g} grains with a tangential speed of {:g} part instead "
                "of meeting",
                b, slide));
        }
        const std::size_t left = 2 * k;
        const std::size_t right = left + 1;
        s.x[left] = grid.x(k);
        s.y[left] = grid.y(k);
        s.x[right] = grid.x(k) + touch + gap;
        s.y[right] = grid.y(k) + b + slide * (gap / pairs.approach_speed);
        s.vx[left] = pairs.frozen_partner ? pairs.approach_speed : pairs.approach_speed / 2;
        s.vx[right] = pairs.frozen_partner ? 0 : -pairs.approach_speed / 2;
        s.vy[left] = pairs.frozen_partner ? slide : slide / 2;
        s.vy[right] = pairs.frozen_partner || slide == 0 ? 0 : -slide / 2;
        if (pairs.frozen_partner) s.frozen[right] = true;
    }
    resize_partners(scene, pairs, sizes.mass_exponent);
    spin_pairs(s, pairs);
}

}  // namespace crossgrain::scene
