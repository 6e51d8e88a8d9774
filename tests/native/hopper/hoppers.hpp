// Hoppers for the tests of the engines, and whole trajectories to compare.
#pragma once

#include "native/hopper/engine.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

namespace crossgrain::tests {

/// Opening angle of walls of slope 3 (degrees).
inline const double slope_3 = 2 * std::atan(1.0 / 3) * 180 / std::numbers::pi;

/// The paper's experiments at a size for tests: C_D = 0.01, C_O = 0, C_I = 0.1, C_W = 10.
inline hopper::Parameters small_hopper() {
    return {.outlet = 10,
            .levels = 120,
            .angle = slope_3,
            .rules = {.c_d = 0.01, .c_o = 0, .c_i = 0.1, .c_w = 10},
            .seed = 7};
}

/// All that an engine shows, iteration by iteration.
struct Trajectory {
    std::vector<std::vector<std::uint8_t>> states;
    std::vector<std::int64_t> moves;
    std::vector<std::int32_t> left_reach, right_reach;
    std::vector<std::uint32_t> flow;
    friend bool operator==(const Trajectory&, const Trajectory&) = default;
};

inline Trajectory trajectory(hopper::Engine& engine, std::int64_t iterations) {
    Trajectory t;
    for (std::int64_t i = 0; i <= iterations; ++i) {
        if (i > 0) engine.advance(1);
        t.states.push_back(engine.state());
        t.moves.push_back(engine.record().moves);
        t.left_reach.push_back(engine.record().left_reach);
        t.right_reach.push_back(engine.record().right_reach);
    }
    t.flow = engine.record().flow;
    return t;
}

inline Trajectory trajectory(const hopper::Parameters& p, hopper::EngineKind kind,
                             std::int64_t iterations) {
    const auto engine = hopper::make_engine(p, kind);
    return trajectory(*engine, iterations);
}

}  // namespace crossgrain::tests
