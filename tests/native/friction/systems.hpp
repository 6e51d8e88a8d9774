// Systems that the tests of the engine share. Reduced units; normal and tangential laws of grains
// with m = 1, r = 1/2 unless a test says otherwise.
#pragma once

#include "native/base/random.hpp"
#include "native/friction/engine.hpp"
#include "native/friction/system.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace crossgrain::tests {

inline constexpr double sphere = 0.4, disc = 0.5;  ///< moments of inertia over m r^2

/// Head-on collisions of two grains of mass 1 have this restitution and contact time; k_t = 2/7
/// k_n, mu = 1/2, no tangential dashpot, no clipping.
inline friction::Parameters frictional_discs(double restitution, double contact_time,
                                             double steps_per_contact) {
    const double rate = -std::log(restitution) / contact_time;
    const double omega = std::numbers::pi / contact_time;
    const double stiffness = (omega * omega + rate * rate) / 2;
    return {.contact = {.stiffness = stiffness,
                        .damping = restitution == 1 ? 0 : rate,
                        .friction = 0.5,
                        .tangential_stiffness = stiffness * 2 / 7},
            .inertia_factor = sphere,
            .dt = contact_time / steps_per_contact};
}

struct Grain {
    double x, y, vx, vy, omega = 0;
    double radius = 0.5, mass = 1;
};

inline void add(friction::State& state, const Grain& g, bool frozen = false) {
    if (frozen) state.frozen.push_back(state.x.size());
    state.x.push_back(g.x);
    state.y.push_back(g.y);
    state.vx.push_back(g.vx);
    state.vy.push_back(g.vy);
    state.omega.push_back(g.omega);
    state.radius.push_back(g.radius);
    state.mass.push_back(g.mass);
}

inline constexpr double gap = 1e-5;  ///< of colliding_pair

/// Two grains that soon meet at unit speed along x, the second one at rest; they slide along each
/// other at `sliding`.
inline friction::State colliding_pair(double sliding, double radius_2 = 0.5) {
    friction::State pair;
    const double mass_2 = std::pow(radius_2 / 0.5, 3);
    add(pair, {.x = -0.5 - gap, .y = 0, .vx = 1, .vy = sliding});
    add(pair, {.x = radius_2, .y = 0, .vx = 0, .vy = 0, .radius = radius_2, .mass = mass_2});
    return pair;
}

/// columns x rows grains of radius 1/2 +- 10 % on a jittered lattice of the given spacing (> 1.3),
/// thermal speed and spins 3; every `frozen_every`-th one frozen (0: none).
inline friction::State hot_gas(std::size_t columns, std::size_t rows, double spacing,
                               std::size_t frozen_every = 0) {
    friction::State state;
    for (std::uint64_t i = 0; i < columns * rows; ++i) {
        const auto number = [&](std::uint64_t k) {
            return 2 * uniform(1, RandomStream::jitter, 3 * i + k) - 1;
        };
        const auto v = normal_pair(1, RandomStream::initial_velocity, 2 * i);
        const auto w = normal_pair(1, RandomStream::initial_velocity, 2 * i + 1);
        const double radius = 0.5 + 0.05 * number(0);
        add(state,
            {.x = spacing * (static_cast<double>(i % columns) + 0.5) + 0.1 * number(1),
             .y = spacing * (static_cast<double>(i / columns) + 0.5) + 0.1 * number(2),
             .vx = 3 * v[0],
             .vy = 3 * v[1],
             .omega = 3 * w[0],
             .radius = radius,
             .mass = std::pow(2 * radius, 3)},
            frozen_every > 0 && i % frozen_every == 0);
    }
    return state;
}

inline friction::State after(const friction::Parameters& p, const friction::State& start,
                             std::int64_t steps) {
    friction::Engine engine(p, start);
    engine.advance(steps);
    return engine.state();
}

/// Of positions, velocities and spins.
inline double largest_difference(const friction::State& a, const friction::State& b) {
    double largest = 0;
    for (const auto values : {&friction::State::x, &friction::State::y, &friction::State::vx,
                              &friction::State::vy, &friction::State::omega}) {
        for (std::size_t i = 0; i < a.x.size(); ++i)
            largest = std::max(largest, std::abs((a.*values)[i] - (b.*values)[i]));
    }
    return largest;
}

/// All 24 of them.
inline std::vector<friction::Conventions> all_conventions() {
    using namespace friction;
    std::vector<Conventions> all;
    for (const auto velocity : {Lever::radius, Lever::contact_point}) {
        for (const auto torque : {Lever::radius, Lever::contact_point}) {
            for (const auto rotation :
                 {SpringRotation::project, SpringRotation::project_and_rescale,
                  SpringRotation::rotate}) {
                for (const auto limit : {CoulombLimit::total, CoulombLimit::spring_only})
                    all.push_back({velocity, torque, rotation, limit});
            }
        }
    }
    return all;
}

}  // namespace crossgrain::tests
