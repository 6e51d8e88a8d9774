// Small scenes with friction that tests of engines and adapters share. Reduced units as in
// scenes.hpp; the springs along the contact are 2/7 of the normal ones unless a test says
// otherwise.
#pragma once

#include "cases/scene/scene.hpp"
#include "tests/support/scenes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>

namespace crossgrain::tests {

inline constexpr double solid_sphere = 0.4, disc = 0.5;  ///< moments of inertia over m r^2

/// Spring with a Coulomb limit of 0.5; the attraction at the end of a contact is cut.
inline scene::ContactLaw frictional_law(double tangential_damping = 0,
                                        scene::Clipping clipping = scene::Clipping::normal_only) {
    return {.stiffness = stiffness,
            .damping = damping,
            .damping_acts_on = scene::Damping::normal_only,
            .clipping = clipping,
            .spins = scene::Spins::on,
            .friction = scene::Friction{.coefficient = 0.5,
                                        .stiffness = stiffness * 2 / 7,
                                        .damping = tangential_damping,
                                        .inertia_factor = solid_sphere}};
}

/// A dashpot with a Coulomb limit instead of the spring.
inline scene::ContactLaw dashpot_law(scene::Clipping clipping = scene::Clipping::normal_only) {
    auto law = frictional_law(20.0, clipping);
    law.friction->force = scene::TangentialForce::dashpot;
    law.friction->stiffness = 0;
    return law;
}

inline scene::ContactLaw per_effective_mass(scene::ContactLaw law) {
    law.damping_scale = scene::DampingScale::effective_mass;
    return law;
}

inline scene::ContactLaw with_inertia(double factor, scene::ContactLaw law) {
    law.friction->inertia_factor = factor;
    return law;
}

inline scene::ContactLaw elastic(scene::ContactLaw law) {
    law.damping = 0;
    return law;
}

struct NamedLaw {
    std::string name;
    scene::ContactLaw law;
};

inline void add_disc(scene::Scene& scene, std::array<double, 2> position,
                     std::array<double, 2> velocity, double omega, double diameter,
                     bool frozen = false) {
    add_grain(scene, position[0], position[1], velocity[0], velocity[1]);
    scene.initial.omega.push_back(omega);
    scene.initial.frozen.push_back(frozen);
    scene.grains.diameters.push_back(diameter);
    scene.grains.masses.push_back(std::pow(diameter / 2, 3));
}

/// The partners of a colliding pair: alike, of two sizes and masses, or the second one frozen.
enum class Partner { alike, smaller, frozen };

/// Adds a pair that touches soon, with unit approach speed along a normal turned by `angle`, and
/// with a tangential velocity and spins.
inline void add_colliding_pair(scene::Scene& scene, std::array<double, 2> place, Partner partner,
                               double angle, double tangential_speed, std::array<double, 2> spins) {
    const bool frozen = partner == Partner::frozen;
    const double second = partner == Partner::smaller ? 1.6 : 2.0;
    const double distance = 1.0 + second / 2 + 0.003;
    const double nx = std::cos(angle), ny = std::sin(angle);
    const double share = frozen ? 1.0 : 0.5;
    const double vx = share * (nx - ny * tangential_speed);
    const double vy = share * (ny + nx * tangential_speed);
    add_disc(scene, place, {vx, vy}, spins[0], 2.0);
    const double still = frozen ? 0.0 : -1.0;
    add_disc(scene, {place[0] + distance * nx, place[1] + distance * ny}, {still * vx, still * vy},
             frozen ? 0.0 : spins[1], second, frozen);
}

/// Oblique and spinning collisions of all partners, each pair on its own: slipping ones, sticking
/// ones, and ones that turn from one into the other.
inline scene::Scene frictional_pairs(const scene::ContactLaw& law, double dt = 1e-4) {
    auto scene = empty_scene("frictional-pairs", dt, 0.2);
    scene.contact = law;
    struct Approach {
        double tangential_speed;
        std::array<double, 2> spins;
    };
    const std::array<Approach, 10> approaches{{{0.2, {0, 0}},
                                               {1, {0, 0}},
                                               {2, {0, 0}},
                                               {-4, {0, 0}},
                                               {8, {0, 0}},
                                               {0, {3, -1}},
                                               {0, {20, 0}},
                                               {1, {-5, 12}},
                                               {-2, {4, -4}},
                                               {3, {-1.5, -1.5}}}};
    double row = 0;
    for (const auto partner : {Partner::alike, Partner::smaller, Partner::frozen}) {
        double column = 0;
        for (const auto& [speed, spins] : approaches) {
            add_colliding_pair(scene, {8 * column, 8 * row}, partner, 0.7 * column + row, speed,
                               spins);
            ++column;
        }
        ++row;
    }
    return scene;
}

/// A grain in the valley of two frozen ones hops from one to the other, and comes back before any
/// neighbour list forgets that they ever touched.
inline scene::Scene grain_in_a_valley(const scene::ContactLaw& law, double dt = 1e-4) {
    auto scene = empty_scene("grain-in-a-valley", dt, 2.0);
    scene.contact = law;
    scene.gravity = 10;
    add_disc(scene, {0.1, 1.62}, {0.4, 0}, 2, 2.0);
    add_disc(scene, {-1.3, 0}, {0, 0}, 0, 2.0, true);
    add_disc(scene, {1.3, 0}, {0, 0}, 0, 2.0, true);
    return scene;
}

/// 64 discs of different sizes in a box that is periodic along x and y: ten contact times. With a
/// tenth of this time step the rounding of v dt, when it is added to positions up to 20, is 3e-11
/// in the end; it hides what the comparison is about.
inline scene::Scene frictional_gas(const scene::ContactLaw& law, double dt = 1e-3) {
    auto scene = empty_scene("frictional-gas", dt, 1.0);
    scene.contact = law;
    scene.periodic_x = scene.periodic_y = 20.0;
    std::mt19937_64 random(3);
    // Not std::uniform_real_distribution: its numbers depend on the library.
    const auto uniform = [&random] {
        return static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0;
    };
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
            const double vx = 5 * uniform(), vy = 5 * uniform();
            const double omega = 5 * uniform(), diameter = 2 + 0.2 * uniform();
            add_disc(scene, {2.5 * column + 1, 2.5 * row + 1}, {vx, vy}, omega, diameter);
        }
    }
    return scene;
}

/// Everything at once: gravity along a pipe whose walls are frozen grains with planes behind them,
/// drag, grains that differ. One of them is fast enough to pass between two grains of the wall.
inline scene::Scene pipe_in_small(const scene::ContactLaw& law, double dt = 1e-4) {
    auto scene = empty_scene("pipe-in-small", dt, 1.0);
    scene.contact = law;
    scene.gravity = 1;
    scene.drag = 0.05;
    scene.periodic_y = 19.2;
    scene.backing = scene::BackingPlanes{.stiffness = stiffness, .left = -0.25, .right = 20.25};
    for (int k = 0; k < 6; ++k) {
        add_disc(scene, {0, 3.2 * k + 0.1}, {0, 0}, 0, 2.0, true);
        add_disc(scene, {20, 3.2 * k + 1.7}, {0, 0}, 0, 2.0, true);
    }
    std::mt19937_64 random(5);
    const auto uniform = [&random] {
        return static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0;
    };
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 5; ++column) {
            const double vx = 5 * uniform(), vy = 5 * uniform();
            const double omega = 5 * uniform(), diameter = 2 + 0.2 * uniform();
            add_disc(scene, {3.3 * column + 3.4, 3.2 * row + 1.6}, {vx, vy}, omega, diameter);
        }
    }
    add_disc(scene, {1.4, 1.7}, {-30, 0}, 0, 0.7);
    return scene;
}

}  // namespace crossgrain::tests
