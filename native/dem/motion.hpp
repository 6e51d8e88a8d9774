// Coordinates of all degrees of freedom as one vector, so that a scheme of integration is written
// once for grains and lid alike.
#pragma once

#include "native/dem/system.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace crossgrain::dem {

/// Shape of all arrays: (2 grains + 1), ordered x of all grains, y of all grains, lid.
struct Motion {
    std::vector<double> q;  ///< positions
    std::vector<double> v;  ///< velocities
    std::vector<double> a;  ///< accelerations, as the scheme left them
};

/// One time step. `end` is a whole multiple of dt, so that time does not drift.
struct TimeStep {
    double start = 0;
    double end = 0;
    double dt = 0;
};

[[nodiscard]] inline Motion motion_of(const State& s) {
    Motion m;
    const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    append(m.q, s.x);
    append(m.q, s.y);
    m.q.push_back(s.lid_height);
    append(m.v, s.vx);
    append(m.v, s.vy);
    m.v.push_back(s.lid_velocity);
    m.a.assign(m.q.size(), 0.0);
    return m;
}

/// Copies positions and velocities back; step and frozen grains are left alone.
inline void copy_motion(const Motion& m, State& s) {
    const auto grains = static_cast<std::ptrdiff_t>(s.x.size());
    s.x.assign(m.q.begin(), m.q.begin() + grains);
    s.y.assign(m.q.begin() + grains, m.q.end() - 1);
    s.vx.assign(m.v.begin(), m.v.begin() + grains);
    s.vy.assign(m.v.begin() + grains, m.v.end() - 1);
    s.lid_height = m.q.back();
    s.lid_velocity = m.v.back();
}

/// The x, the y and the lid's part of such a vector.
[[nodiscard]] inline std::span<const double> x_part(const std::vector<double>& all) {
    return std::span(all).first((all.size() - 1) / 2);
}
[[nodiscard]] inline std::span<const double> y_part(const std::vector<double>& all) {
    return std::span(all).subspan((all.size() - 1) / 2, (all.size() - 1) / 2);
}
[[nodiscard]] inline std::span<double> x_part(std::vector<double>& all) {
    return std::span(all).first((all.size() - 1) / 2);
}
[[nodiscard]] inline std::span<double> y_part(std::vector<double>& all) {
    return std::span(all).subspan((all.size() - 1) / 2, (all.size() - 1) / 2);
}

}  // namespace crossgrain::dem
