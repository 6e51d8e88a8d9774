#include "tests/bench/bench_friction_scenes.hpp"

#include "adapters/native/friction_scene.hpp"
#include "native/base/random.hpp"
#include "native/friction/engine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace crossgrain::bench {
namespace {

/// Head-on collisions of two grains of unit mass have this restitution and
/// contact time.
scene::Scene empty_scene(std::string name, double restitution, double contact_time) {
    const double rate = -std::log(restitution) / contact_time;
    const double omega = std::numbers::pi / contact_time;
    scene::Scene s{.name = std::move(name), .grains = {.diameter = 1, .mass = 1}};
    s.contact.stiffness = (omega * omega + rate * rate) / 2;
    s.contact.damping = rate;
    s.contact.damping_acts_on = scene::Damping::normal_only;
    s.contact.clipping = scene::Clipping::normal_only;
    s.contact.spins = scene::Spins::on;
    s.contact.friction =
        scene::Friction{.coefficient = 0.5, .stiffness = s.contact.stiffness * 2 / 7};
    s.gravity = 1;
    s.dt = contact_time / 20;
    return s;
}

void add(scene::Scene& s, double x, double y, double vx, double vy, double diameter, bool frozen) {
    s.initial.x.push_back(x);
    s.initial.y.push_back(y);
    s.initial.vx.push_back(vx);
    s.initial.vy.push_back(vy);
    s.initial.omega.push_back(0);
    s.initial.frozen.push_back(frozen);
    s.grains.diameters.push_back(diameter);
    s.grains.masses.push_back(diameter * diameter * diameter);
}

double diameter_within(double spread, std::uint64_t grain) {
    return 1 + spread * (2 * uniform(1, RandomStream::jitter, grain) - 1);
}

/// Lets the native engine run the scene for a time; optionally without its first grains after it.
scene::Scene evolved(scene::Scene s, double time, std::size_t removed = 0) {
    friction::Engine engine(adapters::friction_parameters(s), adapters::friction_initial_state(s));
    engine.advance(std::lround(time / s.dt));
    const auto& now = engine.state();
    s.initial.x = now.x, s.initial.y = now.y;
    s.initial.vx = now.vx, s.initial.vy = now.vy;
    s.initial.omega = now.omega;
    const auto drop = [&](auto& values) {
        values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(removed));
    };
    for (auto* values : {&s.initial.x, &s.initial.y, &s.initial.vx, &s.initial.vy, &s.initial.omega,
                         &s.grains.diameters, &s.grains.masses})
        drop(*values);
    drop(s.initial.frozen);
    return s;
}

}  // namespace

scene::Scene pipe_of_grains() {
    constexpr double length = 220;
    constexpr std::uint64_t grains = 420, wall = 137;
    auto s = empty_scene("bench/pipe", 0.8, 0.025);
    s.periodic_y = length;
    s.backing = scene::BackingPlanes{.stiffness = s.contact.stiffness, .left = 0, .right = 11};
    for (std::uint64_t k = 0; k < wall; ++k) {
        const double spacing = length / wall;
        add(s, 0, spacing * static_cast<double>(k), 0, 0, 1, true);
        add(s, 11, spacing * (static_cast<double>(k) + 0.5), 0, 0, 1, true);
    }
    for (std::uint64_t i = 0; i < grains; ++i) {
        const auto v = normal_pair(1, RandomStream::initial_velocity, i);
        const std::uint64_t row = i / 6;
        add(s, 1.5 + 1.6 * static_cast<double>(i % 6), 0.5 + 3.14 * static_cast<double>(row),
            5 * v[0], 5 * v[1] - 8, diameter_within(0.05, i), false);
    }
    return evolved(std::move(s), 50);
}

scene::Scene hopper_of_grains(double height) {
    constexpr double outlet = 20, angle = std::numbers::pi / 6, spacing = 1.25;
    auto s = empty_scene("bench/hopper", 0.5, 0.0228);
    std::size_t plug = 0;
    for (; plug < static_cast<std::size_t>(outlet); ++plug)
        add(s, static_cast<double>(plug) + 0.5 - outlet / 2, -0.5, 0, 0, 1, true);
    const auto wall = static_cast<int>(std::ceil(1.25 * height / std::cos(angle)));
    for (int along = 0; along < wall; ++along) {
        for (const double side : {-1.0, 1.0}) {
            add(s, side * (outlet / 2 + 0.5 + along * std::sin(angle)), along * std::cos(angle), 0,
                0, 1, true);
        }
    }
    std::uint64_t i = 0;
    const auto rows = static_cast<int>(std::ceil((1.1 * height - 1) / spacing));
    for (int row = 0; row < rows; ++row) {
        const double y = 1 + row * spacing;
        const double half = outlet / 2 + y * std::tan(angle) - 1.2;
        const auto columns = static_cast<int>(std::ceil(2 * half / spacing));
        for (int column = 0; column < columns; ++column, ++i) {
            const double x = column * spacing - half;
            const auto v = normal_pair(1, RandomStream::initial_velocity, i);
            add(s, x, y, 0.1 * v[0], 0.1 * v[1], diameter_within(0.2, i), false);
        }
    }
    return evolved(evolved(std::move(s), 20, plug), 3);
}

std::size_t mobile_grains(const scene::Scene& s) {
    return static_cast<std::size_t>(
        std::count(s.initial.frozen.begin(), s.initial.frozen.end(), false));
}

}  // namespace crossgrain::bench
