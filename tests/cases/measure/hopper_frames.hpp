// Hoppers filled by hand, with a known answer, to calibrate estimators.
#pragma once

#include "cases/measure/results.hpp"
#include "cases/scene/hopper_automaton.hpp"
#include "cases/scene/hopper_frame.hpp"
#include "native/base/random.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace crossgrain::tests {

/// The paper's hopper (slope 3) with `replicas` replicas of `iterations` iterations.
inline scene::HopperAutomaton hopper_scene(int outlet, int levels, double angle, int replicas,
                                           std::int64_t iterations, std::int64_t every) {
    scene::HopperAutomaton scene{.name = "synthetic"};
    scene.outlet = outlet;
    scene.levels = levels;
    scene.angles = {angle};
    scene.iterations = iterations;
    scene.every = every;
    scene.replicas = replicas;
    scene.seed = 1;
    return scene;
}

/// The sites of a hopper: |x| <= x0 + y tan(theta/2), c + k + N - 1 even.
inline std::vector<scene::HopperLevel> hopper_levels(int outlet, int levels, double angle) {
    std::vector<scene::HopperLevel> result;
    std::size_t offset = 0;
    const double column = std::numbers::sqrt3 / 2;
    for (int k = 0; k < levels; ++k) {
        const double half_width =
            (outlet - 1) * column + k / 2.0 * std::tan(angle * std::numbers::pi / 360) + 1e-9;
        auto last = static_cast<std::int32_t>(half_width / column);
        if ((last + k + outlet - 1) % 2 != 0) --last;
        result.push_back({.first = -last, .last = last, .offset = offset});
        offset += result.back().sites();
    }
    return result;
}

/// A filling that owns its arrays; `state_of(column, half-level)` gives the states.
struct HopperFilling {
    std::vector<scene::HopperLevel> levels;
    std::vector<std::uint8_t> state, twin;
    std::vector<std::uint32_t> flow;
    std::int32_t left_reach = -1, right_reach = -1;

    using StateOf = std::function<std::uint8_t(std::int64_t, std::int64_t)>;
    HopperFilling(const scene::HopperAutomaton& scene, const StateOf& state_of)
        : levels(hopper_levels(scene.outlet, scene.levels, scene.angles.front())) {
        state = states(state_of);
    }
    [[nodiscard]] std::vector<std::uint8_t> states(const StateOf& state_of) const {
        std::vector<std::uint8_t> result;
        for (std::size_t k = 0; k < levels.size(); ++k) {
            for (std::size_t i = 0; i < levels[k].sites(); ++i) {
                result.push_back(state_of(levels[k].first + 2 * static_cast<std::int64_t>(i),
                                          static_cast<std::int64_t>(k)));
            }
        }
        return result;
    }
    [[nodiscard]] scene::HopperFrame view(const scene::HopperAutomaton& scene, int replica,
                                          std::int64_t iteration,
                                          std::size_t angle_index = 0) const {
        return {.angle_index = angle_index,
                .angle = scene.angles[angle_index],
                .replica = replica,
                .iteration = iteration,
                .last = iteration == scene.iterations,
                .levels = levels,
                .state = state,
                .twin = twin,
                .flow = flow,
                .left_reach = left_reach,
                .right_reach = right_reach};
    }
};

/// An orientation 1..3 that depends on the place and the seed only.
inline std::uint8_t random_orientation(std::uint64_t seed, std::int64_t column,
                                       std::int64_t level) {
    const auto n = static_cast<std::uint64_t>((column + 100'000) * 1'000'000 + level + 1000);
    return static_cast<std::uint8_t>(1 + 3 * uniform(seed, RandomStream::jitter, n));
}

inline std::string state_found(const measure::Results& results) {
    std::string label;
    for (const auto& finding : results.findings) {
        if (finding.name == "state") label += finding.label;
    }
    return label;
}

}  // namespace crossgrain::tests
