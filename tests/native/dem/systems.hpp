// Systems that the tests of the engine share: every law variant, a hot gas, and their balances.
// Reduced units: m = 1, d = 2; e = 0.8 and t_col = 0.1 in a head-on collision.
#pragma once

#include "native/base/random.hpp"
#include "native/dem/engine.hpp"
#include "native/dem/system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::tests {

struct LawVariant {
    std::string name;
    dem::DampingDirection damping;
    dem::AttractiveTail tail;
};

inline const std::array<LawVariant, 6> law_variants{
    {{"full, kept", dem::DampingDirection::full_vector, dem::AttractiveTail::kept},
     {"full, contact cut", dem::DampingDirection::full_vector,
      dem::AttractiveTail::contact_force_cut},
     {"full, normal cut", dem::DampingDirection::full_vector,
      dem::AttractiveTail::normal_force_cut},
     {"normal, kept", dem::DampingDirection::normal_only, dem::AttractiveTail::kept},
     {"normal, contact cut", dem::DampingDirection::normal_only,
      dem::AttractiveTail::contact_force_cut},
     {"normal, normal cut", dem::DampingDirection::normal_only,
      dem::AttractiveTail::normal_force_cut}}};

/// Open, without plates and gravity.
inline dem::Parameters free_discs(const LawVariant& law, double dt) {
    return {.diameter = 2.0,
            .mass = 1.0,
            .stiffness = 495.96987227912376,
            .damping = 2.2314355131420975,
            .damping_direction = law.damping,
            .tail = law.tail,
            .dt = dt};
}

inline void add_disc(dem::State& state, double x, double y, double vx, double vy) {
    state.x.push_back(x);
    state.y.push_back(y);
    state.vx.push_back(vx);
    state.vy.push_back(vy);
}

/// side^2 discs on a jittered square lattice of the given spacing (> 2.4), thermal speed 3.
inline dem::State hot_gas(std::size_t side, double spacing, std::uint64_t seed = 1) {
    dem::State state;
    for (std::uint64_t i = 0; i < side * side; ++i) {
        const std::uint64_t row = i / side;
        const auto jitter = [&](std::uint64_t k) {
            return 0.4 * (uniform(seed, RandomStream::jitter, 2 * i + k) - 0.5);
        };
        const auto v = normal_pair(seed, RandomStream::initial_velocity, i);
        add_disc(state, spacing * (static_cast<double>(i % side) + 0.5) + jitter(0),
                 spacing * (static_cast<double>(row) + 0.5) + jitter(1), 3 * v[0], 3 * v[1]);
    }
    return state;
}

inline double nearest_image(double separation, const std::optional<double>& period) {
    return period ? std::remainder(separation, *period) : separation;
}

/// Total momentum along x and y, the lid included.
inline std::array<double, 2> momentum(const dem::Parameters& p, const dem::State& s) {
    std::array<double, 2> sum{};
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        sum[0] += p.mass * s.vx[i];
        sum[1] += p.mass * s.vy[i];
    }
    if (const auto* lid = std::get_if<dem::InertialLid>(&p.lid)) {
        sum[1] += lid->mass * s.lid_velocity;
    }
    return sum;
}

/// Kinetic energy plus the springs of all pairs, from a plain double loop.
inline double pair_energy(const dem::Parameters& p, const dem::State& s) {
    double energy = 0;
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        energy += p.mass * (s.vx[i] * s.vx[i] + s.vy[i] * s.vy[i]) / 2;
        for (std::size_t j = 0; j < i; ++j) {
            const double overlap =
                p.diameter - std::hypot(nearest_image(s.x[i] - s.x[j], p.period_x),
                                        nearest_image(s.y[i] - s.y[j], p.period_y));
            if (overlap > 0) energy += p.stiffness * overlap * overlap / 2;
        }
    }
    return energy;
}

inline dem::State after(const dem::Parameters& p, dem::State state, std::int64_t steps) {
    dem::Engine engine(p, std::move(state));
    engine.advance(steps);
    return engine.state();
}

/// Largest difference of any position or velocity of a grain or the lid.
inline double largest_difference(const dem::State& a, const dem::State& b) {
    double largest =
        std::max(std::abs(a.lid_height - b.lid_height), std::abs(a.lid_velocity - b.lid_velocity));
    const auto compare = [&](const std::vector<double>& p, const std::vector<double>& q) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            // Written so that a NaN is a difference.
            const double difference = std::abs(p.at(i) - q.at(i));
            if (!(difference <= largest)) largest = difference;
        }
    };
    compare(a.x, b.x);
    compare(a.y, b.y);
    compare(a.vx, b.vx);
    compare(a.vy, b.vy);
    return largest;
}

}  // namespace crossgrain::tests
