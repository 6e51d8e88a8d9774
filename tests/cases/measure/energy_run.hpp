// One run of the energy balance on synthetic frames, with the contact law of e = 0.8, t_col = 0.1.
#pragma once

#include "cases/measure/bed/energy_balance.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"

#include <vector>

namespace crossgrain::tests {

inline constexpr double k = 495.96987227912376, eta = 2.2314355131420975, t_col = 0.1, d = 2;

inline scene::Scene damped_scene(std::size_t grains, double interval) {
    auto scene = plain_scene(grains);
    scene.contact.stiffness = k;
    scene.contact.damping = eta;
    scene.dt = interval;
    return scene;
}

inline measure::Results run(const scene::Scene& scene, const std::vector<SyntheticFrame>& frames,
                            measure::EnergyBalanceOptions options = {}) {
    measure::EnergyBalance estimator(scene, options);
    for (const auto& frame : frames)
        estimator.add(frame.view());
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace crossgrain::tests
