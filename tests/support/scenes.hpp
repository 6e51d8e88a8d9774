// Small scenes that tests of engines and adapters share, each with one thing to see. Reduced units:
// m = 1, d = 2; the contact law has e = 0.8 and t_col = 0.1 in a head-on collision.
#pragma once

#include "cases/scene/scene.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace crossgrain::tests {

inline constexpr double stiffness = 495.96987227912376;  ///< k for e = 0.8, t_col = 0.1, m = 1
inline constexpr double damping = 2.2314355131420975;    ///< eta = -ln(e) / t_col

/// Taguchi's law, no plates, no gravity, open, no grains yet: `duration` time units, ten frames.
inline scene::Scene empty_scene(std::string name, double dt, double duration) {
    scene::Scene scene;
    scene.name = std::move(name);
    scene.grains = {.diameter = 2.0, .mass = 1.0};
    scene.contact.stiffness = stiffness;
    scene.contact.damping = damping;
    scene.dt = dt;
    scene.frame_every = std::lround(duration / dt / 10);
    scene.steps = scene.frame_every * 10;
    scene.seed = 1;
    return scene;
}

inline void add_grain(scene::Scene& scene, double x, double y, double vx, double vy) {
    scene.initial.x.push_back(x);
    scene.initial.y.push_back(y);
    scene.initial.vx.push_back(vx);
    scene.initial.vy.push_back(vy);
}

/// Approach speed 1 along x; contact from t = 0.1 to about 0.2.
inline scene::Scene head_on_pair(double dt = 1e-4) {
    auto scene = empty_scene("head-on-pair", dt, 0.5);
    add_grain(scene, -1.05, 0.0, 0.5, 0.0);
    add_grain(scene, 1.05, 0.0, -0.5, 0.0);
    return scene;
}

/// As head_on_pair with an impact parameter, so that normal and tangential parts differ.
inline scene::Scene oblique_pair(double dt = 1e-4) {
    auto scene = empty_scene("oblique-pair", dt, 0.8);
    add_grain(scene, -1.05, 0.35, 1.5, 0.2);
    add_grain(scene, 1.0, -0.4, -0.5, 0.1);
    return scene;
}

/// One grain (and a far spectator: a scene has at least two) falls on the bottom plate at rest.
inline scene::Scene bounce_on_bottom(scene::PlateContact touches, double dt = 1e-4) {
    auto scene = empty_scene("bounce-on-bottom", dt, 1.0);
    const double reach = touches == scene::PlateContact::surface ? 1.0 : 0.0;
    scene.plates = {.stiffness = stiffness,
                    .touches = touches,
                    .bottom = scene::PrescribedPlate{.height = -0.3},
                    .lid = {}};
    add_grain(scene, 0.0, reach, 0.1, -1.0);
    add_grain(scene, 7.0, 5.0, 0.0, 0.3);
    scene.gravity = 1.0;
    return scene;
}

/// Without gravity: a grain at speed 1 meets a lid of mass 3 at rest, once.
inline scene::Scene free_lid_collision(double dt = 1e-4) {
    auto scene = empty_scene("free-lid-collision", dt, 1.0);
    scene.plates = {.stiffness = stiffness,
                    .touches = scene::PlateContact::centre,
                    .bottom = {},
                    .lid = scene::FreeLid{.mass = 3.0, .height = 2.0}};
    add_grain(scene, 0.0, 1.7, 0.0, 1.0);
    add_grain(scene, 6.0, -2.0, 0.0, 0.0);
    return scene;
}

/// With gravity, a vibrating bottom and grains between: the vibrated bed in small. Neighbours start
/// a little apart: whether a pair at exactly d touches would be decided by round-off.
inline scene::Scene small_bed(double dt = 1e-4) {
    auto scene = empty_scene("small-bed", dt, 2.0);
    scene.periodic_x = 12.6;
    scene.gravity = 1.0;
    scene.plates = {.stiffness = stiffness,
                    .touches = scene::PlateContact::centre,
                    .bottom =
                        scene::PrescribedPlate{.height = 0.0, .amplitude = 0.5, .period = 2.0},
                    .lid = scene::FreeLid{.mass = 5.0, .height = 5.2}};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 6; ++column) {
            add_grain(scene, 2.1 * column + row % 2 + 0.3, 0.6 + 1.8 * row, 0.1 * (column % 3 - 1),
                      0.05 * (row - 1));
        }
    }
    return scene;
}

/// A grain hit by a plate that moves as cos: the plate's phase and time are seen.
inline scene::Scene moving_bottom(double dt = 1e-4) {
    auto scene = empty_scene("moving-bottom", dt, 2.0);
    scene.gravity = 1.0;
    scene.plates = {.stiffness = stiffness,
                    .touches = scene::PlateContact::centre,
                    .bottom =
                        scene::PrescribedPlate{.height = 0.25, .amplitude = 0.5, .period = 1.3},
                    .lid = {}};
    add_grain(scene, 0.0, 1.0, 0.0, 0.0);
    add_grain(scene, 5.0, 0.7, 0.2, -0.4);
    return scene;
}

/// A lid that is moved, above a bottom at rest, touching the grain's surface.
inline scene::Scene prescribed_lid(double dt = 1e-4) {
    auto scene = moving_bottom(dt);
    scene.name = "prescribed-lid";
    scene.plates.touches = scene::PlateContact::surface;
    scene.plates.bottom = scene::PrescribedPlate{.height = -0.5};
    scene.plates.lid = scene::PrescribedPlate{.height = 2.0, .amplitude = 0.2, .period = 0.9};
    return scene;
}

/// A grain hits a grain that never moves: a wrong effective mass is seen in e and t_col.
inline scene::Scene frozen_target(double dt = 1e-4) {
    auto scene = oblique_pair(dt);
    scene.name = "frozen-target";
    scene.initial.vx[1] = scene.initial.vy[1] = 0.0;
    scene.initial.frozen = {false, true};
    return scene;
}

/// The vibrated bed with an obstacle: grains, frozen grains and a lid are three kinds of bodies.
inline scene::Scene bed_with_obstacle(double dt = 1e-4) {
    auto scene = small_bed(dt);
    scene.name = "bed-with-obstacle";
    scene.initial.frozen.assign(scene.grain_count(), false);
    scene.initial.frozen[8] = scene.initial.frozen[9] = true;
    return scene;
}

/// A dense periodic-in-x gas of 36 grains: many contacts, also across the period. All start inside
/// [0, 15): codes that wrap positions and codes that do not round v dt differently, by the same
/// amount in every step (4e-13 after 500 steps).
inline scene::Scene small_gas(double dt = 1e-4) {
    auto scene = empty_scene("small-gas", dt, 0.5);
    scene.periodic_x = 15.0;
    std::mt19937_64 random(7);
    // Not std::uniform_real_distribution: its numbers depend on the library.
    const auto uniform = [&random] {
        return static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0;
    };
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 6; ++column) {
            const double x = 2.5 * column + 1.2 + 0.2 * uniform();
            const double y = 2.5 * row + 1.2 + 0.2 * uniform();
            const double vx = 3.0 * uniform(), vy = 3.0 * uniform();
            add_grain(scene, x, y, vx, vy);
        }
    }
    return scene;
}

/// The same, periodic in both directions.
inline scene::Scene doubly_periodic_gas(double dt = 1e-4) {
    auto scene = small_gas(dt);
    scene.name = "doubly-periodic-gas";
    scene.periodic_y = 15.0;
    return scene;
}

/// Mass, diameter and damping that are not those of the other scenes, contacts from the start, and
/// more grains than a code's small-number settings: where a factor m or d is missing, it is seen.
inline scene::Scene heavy_small_gas(double dt = 1e-4) {
    auto scene = small_gas(dt);
    scene.name = "heavy-small-gas";
    scene.grains = {.diameter = 0.7, .mass = 2.3};
    scene.contact.damping = 3.1;
    scene.periodic_x = 7.0;
    scene.initial = {};
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 10; ++column) {
            const int i = 10 * row + column;
            add_grain(scene, 0.7 * column + 0.03 * (i % 3), 0.72 * row + 0.04 * (i % 4),
                      0.5 * (i % 5) - 1.0, 0.4 * (i % 7) - 1.2);
        }
    }
    return scene;
}

}  // namespace crossgrain::tests
