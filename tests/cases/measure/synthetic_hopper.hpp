// A hopper of frozen grains with mobile grains on a grid in it, whose motion a test prescribes.
#pragma once

#include "cases/measure/estimator.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace crossgrain::tests {

/// Grains of diameter 1; walls of touching grains from the outlet at y = 5 to 100 above it, opening
/// angle theta (degrees), axis x = 7; mobile grains on a square grid of spacing 1.1, first in the
/// arrays and ordered by height. Frames every 0.1 up to t = 30.
inline scene::Scene hopper_scene(double theta, double outlet = 20) {
    scene::Scene scene = plain_scene(0);
    scene.grains.diameter = 1;
    scene.dt = 0.01;
    scene.frame_every = 10;
    scene.steps = 3000;
    const double half = theta * std::numbers::pi / 360, tangent = std::tan(half);
    auto& state = scene.initial;
    const auto place = [&](double x, double y, bool frozen) {
        state.x.push_back(7 + x);
        state.y.push_back(5 + y);
        state.frozen.push_back(frozen);
    };
    for (double y = 1; y < 100; y += 1.1) {
        const double reach = outlet / 2 + 0.5 + y * tangent - 1.05 * std::hypot(1, tangent);
        for (double x = 0; x <= reach; x += 1.1) {
            place(x, y, false);
            if (x > 0) place(-x, y, false);
        }
        if (std::fmod(reach, 1.1) > 0.1) {  // touching the wall
            place(reach, y, false);
            place(-reach, y, false);
        }
    }
    for (double s = 0; s <= 100 / std::cos(half); s += 1) {
        const double x = outlet / 2 + 0.5 + s * std::sin(half), y = s * std::cos(half);
        place(x, y, true);
        place(-x, y, true);
    }
    state.vx.assign(state.x.size(), 0.0);
    state.vy = state.vx;
    return scene;
}

struct GrainState {
    double x = 0, y = 0, vx = 0, vy = 0;
};

/// Feeds every frame to the estimator; `motion` gives the state of mobile grain i at time t.
inline measure::Results run_hopper(const scene::Scene& scene, measure::Estimator& estimator,
                                   const std::function<GrainState(std::size_t, double)>& motion) {
    auto x = scene.initial.x, y = scene.initial.y, vx = scene.initial.vx, vy = scene.initial.vy;
    for (std::int64_t step = 0; step <= scene.steps; step += scene.frame_every) {
        const double t = static_cast<double>(step) * scene.dt;
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (scene.initial.frozen[i]) continue;
            const GrainState state = motion(i, t);
            x[i] = state.x;
            y[i] = state.y;
            vx[i] = state.vx;
            vy[i] = state.vy;
        }
        estimator.add(
            {.step = step, .time = t, .x = x, .y = y, .vx = vx, .vy = vy, .lid = {}, .omega = {}});
    }
    measure::Results results;
    estimator.finish(results);
    return results;
}

}  // namespace crossgrain::tests
