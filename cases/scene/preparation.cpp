#include "cases/scene/preparation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace crossgrain::scene {
namespace {

template <class T>
void remove_marked(std::vector<T>& values, const std::vector<bool>& marked) {
    if (values.empty()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!marked[i]) values[kept++] = values[i];
    }
    values.resize(kept);
}

void remove_grains(Scene& scene, const std::vector<bool>& removed) {
    auto& s = scene.initial;
    for (auto* values :
         {&s.x, &s.y, &s.vx, &s.vy, &s.omega, &scene.grains.diameters, &scene.grains.masses})
        remove_marked(*values, removed);
    remove_marked(s.frozen, removed);
}

bool frozen(const Scene& scene, std::size_t i) {
    return scene.has_frozen_grains() && scene.initial.frozen[i];
}

/// Frozen grains higher than any that moves, by more than a diameter.
void mark_above_filling(const Scene& scene, std::vector<bool>& removed) {
    double highest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.grain_count(); ++i) {
        if (!frozen(scene, i)) highest = std::max(highest, scene.initial.y[i]);
    }
    for (std::size_t i = 0; i < scene.grain_count(); ++i) {
        if (frozen(scene, i) && scene.initial.y[i] > highest + scene.grains.diameter) {
            removed[i] = true;
        }
    }
}

}  // namespace

Scene without_removed(Scene scene) {
    if (!scene.preparation) return scene;
    remove_grains(scene, scene.preparation->removed);
    scene.preparation.reset();
    return scene;
}

Scene start_of_run(Scene scene, const InitialState& settled) {
    scene.initial.x = settled.x;
    scene.initial.y = settled.y;
    scene.initial.vx.assign(scene.grain_count(), 0);
    scene.initial.vy.assign(scene.grain_count(), 0);
    scene.initial.omega.clear();
    if (scene.preparation) mark_above_filling(scene, scene.preparation->removed);
    scene = without_removed(std::move(scene));
    const double factor = contact_free_dilation(scene);
    for (auto* positions : {&scene.initial.x, &scene.initial.y}) {
        for (double& value : *positions)
            value *= factor;
    }
    return scene;
}

double contact_free_dilation(const Scene& scene) {
    const auto& s = scene.initial;
    std::vector<std::size_t> by_height(scene.grain_count());
    std::iota(by_height.begin(), by_height.end(), std::size_t{0});
    std::sort(by_height.begin(), by_height.end(),
              [&](std::size_t a, std::size_t b) { return s.y[a] < s.y[b]; });
    double largest = 0;
    for (std::size_t i = 0; i < scene.grain_count(); ++i)
        largest = std::max(largest, scene.grains.diameter_of(i));
    double factor = 1;
    for (std::size_t a = 0; a < by_height.size(); ++a) {
        const std::size_t i = by_height[a];
        for (std::size_t b = a + 1; b < by_height.size(); ++b) {
            const std::size_t j = by_height[b];
            if (s.y[j] - s.y[i] >= largest) break;
            if (frozen(scene, i) && frozen(scene, j)) continue;
            const double reach = (scene.grains.diameter_of(i) + scene.grains.diameter_of(j)) / 2;
            // A little more than touching: the products below are rounded.
            const double needed = reach / std::hypot(s.x[j] - s.x[i], s.y[j] - s.y[i]);
            if (needed >= 1) factor = std::max(factor, needed * (1 + 1e-9));
        }
    }
    return factor;
}

}  // namespace crossgrain::scene
