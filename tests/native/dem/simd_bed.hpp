// The shaken bed that the tests of the simd kernel run in both kernels.
#pragma once

#include "native/base/random.hpp"
#include "tests/native/dem/systems.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace crossgrain::tests {

inline constexpr double dt = 1e-3;
inline constexpr double contact_time = 0.1;
inline constexpr dem::Scheme both_schemes[] = {dem::Scheme::verlet_half_step,
                                               dem::Scheme::verlet_predicted};

/// A shaken bed under a free lid, 32 columns and a period of 65: nothing is left out. The number of
/// grains is no multiple of any vector's lanes.
inline dem::Parameters bed_parameters(const LawVariant& law, dem::Scheme scheme) {
    auto p = free_discs(law, dt);
    p.gravity = 1;
    p.period_x = 65;
    p.plate_stiffness = p.stiffness;
    p.bottom = dem::MovingPlate{.height = -2.1, .amplitude = 2, .omega = std::numbers::pi / 3};
    p.lid = dem::InertialLid{.mass = 50};
    p.scheme = scheme;
    return p;
}

inline dem::State bed(std::size_t grains = 301, std::size_t columns = 32, double speed = 0.1) {
    dem::State s;
    for (std::uint64_t i = 0; i < grains; ++i) {
        const std::uint64_t row = i / columns;
        const auto jitter = [&](std::uint64_t k) {
            return 0.1 * (uniform(7, RandomStream::jitter, 2 * i + k) - 0.5);
        };
        const auto v = normal_pair(7, RandomStream::initial_velocity, i);
        // Beyond the period on both sides: positions are unwrapped.
        add_disc(s,
                 2.03 * static_cast<double>(i % columns) - 30 + (row % 2 ? 1.0 : 0.0) + jitter(0),
                 1.8 * static_cast<double>(row) + jitter(1), speed * v[0], speed * v[1]);
    }
    const std::size_t rows = grains / columns;
    s.lid_height = 1.8 * static_cast<double>(rows) + 0.5;
    return s;
}

inline dem::State run_with(dem::Parameters p, dem::Kernel kernel, dem::Precision precision,
                           std::int64_t steps, const dem::State& start) {
    p.kernel = kernel;
    p.precision = precision;
    return after(p, start, steps);
}

inline dem::State scalar(const dem::Parameters& p, std::int64_t steps,
                         const dem::State& start = bed()) {
    return run_with(p, dem::Kernel::scalar, dem::Precision::double_precision, steps, start);
}
inline dem::State simd(const dem::Parameters& p, std::int64_t steps,
                       const dem::State& start = bed()) {
    return run_with(p, dem::Kernel::simd, dem::Precision::double_precision, steps, start);
}
inline dem::State mixed(const dem::Parameters& p, std::int64_t steps,
                        const dem::State& start = bed()) {
    return run_with(p, dem::Kernel::simd, dem::Precision::mixed, steps, start);
}

inline double largest_distance(const dem::State& a, const dem::State& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.x.size(); ++i)
        largest = std::max(largest, std::hypot(a.x[i] - b.x[i], a.y[i] - b.y[i]));
    return largest;
}

}  // namespace crossgrain::tests
