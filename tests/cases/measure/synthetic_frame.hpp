// Frames made by hand, with a known answer, to calibrate estimators.
#pragma once

#include "cases/measure/results.hpp"
#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace crossgrain::tests {

/// A frame that owns its arrays.
struct SyntheticFrame {
    std::int64_t step = 0;
    double time = 0;
    std::vector<double> x, y, vx, vy;
    std::optional<scene::LidState> lid;

    void add_grain(double px, double py, double pvx, double pvy) {
        x.push_back(px);
        y.push_back(py);
        vx.push_back(pvx);
        vy.push_back(pvy);
    }
    [[nodiscard]] scene::Frame view() const { return {step, time, x, y, vx, vy, lid}; }
};

/// `grains` grains of diameter 2 and mass 1, undamped contacts of stiffness 496, open, no plates.
inline scene::Scene plain_scene(std::size_t grains) {
    scene::Scene scene;
    scene.name = "synthetic";
    scene.grains = {.diameter = 2, .mass = 1};
    scene.contact.stiffness = 496;
    scene.dt = 1e-3;
    scene.steps = 1000;
    scene.frame_every = 1;
    scene.initial.x.assign(grains, 0.0);
    scene.initial.y = scene.initial.vx = scene.initial.vy = scene.initial.x;
    return scene;
}

inline const measure::Measurement* find(const measure::Results& results,
                                        const std::string& observable) {
    for (const auto& one : results.measurements) {
        if (one.observable == observable) return &one;
    }
    return nullptr;
}

/// A copy of the measurement, which the test needs; fails the test if it is missing.
inline measure::Measurement get(const measure::Results& results, const std::string& observable) {
    const auto* found = find(results, observable);
    if (!found) throw std::runtime_error("no measurement '" + observable + "'");
    return *found;
}

/// A copy of one column of a series; fails the test if it is missing.
inline std::vector<double> column(const measure::Results& results, const std::string& series,
                                  const std::string& name) {
    for (const auto& one : results.series) {
        for (std::size_t c = 0; c < one.columns.size(); ++c) {
            if (one.name == series && one.columns[c] == name) return one.values[c];
        }
    }
    throw std::runtime_error("no column '" + name + "' in series '" + series + "'");
}

}  // namespace crossgrain::tests
