#include "cases/scene/initial_draws.hpp"

#include "cases/scene/limits.hpp"
#include "native/base/random.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace crossgrain::scene {
namespace {

void remove_drift(std::vector<double>& v) {
    double mean = 0;
    for (const double value : v)
        mean += value;
    mean /= static_cast<double>(v.size());
    for (double& value : v)
        value -= mean;
}

}  // namespace

std::size_t grains_for(double count, const char* what) {
    // Not a number is too many as well.
    if (count <= static_cast<double>(most_grains)) return static_cast<std::size_t>(count);
    throw std::invalid_argument(
        fmt::format("{} would need {:.6g} grains, more than {}", what, count, most_grains));
}

void resize(InitialState& s, std::size_t n) {
    s.x.assign(n, 0);
    s.y.assign(n, 0);
    s.vx.assign(n, 0);
    s.vy.assign(n, 0);
}

double gap_of(std::size_t k, std::size_t count, double lead_steps, double speed, double dt) {
    const double phase = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    return (lead_steps + phase) * speed * dt;
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

void draw_spins(Scene& scene, double spread) {
    if (spread == 0) return;
    auto& omega = scene.initial.omega;
    omega.assign(scene.grain_count(), 0);
    for (std::size_t i = 0; i < omega.size(); ++i)
        omega[i] = spread * normal_pair(scene.seed, RandomStream::initial_spin, i)[0];
}

void jitter(Scene& scene, std::size_t i, double reach) {
    const double angle =
        2 * std::numbers::pi * uniform(scene.seed, RandomStream::initial_position, i);
    const double radius = reach * uniform(scene.seed, RandomStream::jitter, i);
    scene.initial.x[i] += radius * std::cos(angle);
    scene.initial.y[i] += radius * std::sin(angle);
}

double mass_of(const Grains& grains, double ratio, double exponent) {
    return grains.mass * std::pow(ratio, exponent);
}

void draw_sizes(Scene& scene, const SizeSpread& sizes) {
    if (sizes.spread == 0) return;
    auto& grains = scene.grains;
    const std::size_t n = scene.grain_count();
    grains.diameters.resize(n);
    grains.masses.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double u = uniform(scene.seed, RandomStream::initial_size, i);
        const double ratio = 1 + sizes.spread * (2 * u - 1);
        grains.diameters[i] = grains.diameter * ratio;
        grains.masses[i] = mass_of(grains, ratio, sizes.mass_exponent);
    }
}

void add_frozen(Scene& scene, double x, double y) {
    auto& s = scene.initial;
    s.frozen.resize(s.x.size(), false);
    s.x.push_back(x);
    s.y.push_back(y);
    s.vx.push_back(0);
    s.vy.push_back(0);
    s.frozen.push_back(true);
    if (!s.omega.empty()) s.omega.push_back(0);
    if (!scene.grains.differ()) return;
    scene.grains.diameters.push_back(scene.grains.diameter);
    scene.grains.masses.push_back(scene.grains.mass);
}

}  // namespace crossgrain::scene
