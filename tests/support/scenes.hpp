// Small scenes that tests of engines and adapters share, each with one thing to see. Reduced units:
// m = 1, d = 2; the contact law has e = 0.8 and t_col = 0.1 in a head-on collision.
#pragma once

#include "cases/scene/scene.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
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

/// The same with gravity, a vibrating bottom and grains between: the vibrated bed in small.
inline scene::Scene small_bed(double dt = 1e-4) {
    auto scene = empty_scene("small-bed", dt, 3.0);
    scene.periodic_x = 12.0;
    scene.gravity = 1.0;
    scene.plates = {.stiffness = stiffness,
                    .touches = scene::PlateContact::centre,
                    .bottom =
                        scene::PrescribedPlate{.height = 0.0, .amplitude = 0.5, .period = 2.0},
                    .lid = scene::FreeLid{.mass = 5.0, .height = 5.2}};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 6; ++column) {
            add_grain(scene, 2.0 * column + row % 2 + 0.3, 0.6 + row * std::numbers::sqrt3,
                      0.1 * (column % 3 - 1), 0.05 * (row - 1));
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

/// A dense periodic-in-x gas of 36 grains: many contacts, also across the period.
inline scene::Scene small_gas(double dt = 1e-4) {
    auto scene = empty_scene("small-gas", dt, 1.0);
    scene.periodic_x = 15.0;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 6; ++column) {
            add_grain(scene, 2.5 * column + 0.2 * uniform(random),
                      2.5 * row + 0.2 * uniform(random), 3.0 * uniform(random),
                      3.0 * uniform(random));
        }
    }
    return scene;
}

}  // namespace crossgrain::tests
