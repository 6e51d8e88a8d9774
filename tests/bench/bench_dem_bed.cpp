#include "tests/bench/bench_dem_bed.hpp"

#include "native/base/random.hpp"
#include "native/dem/engine.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace crossgrain::bench {
namespace {

constexpr double dt = 1e-3, start_time = 40, shaking_period = 6;
constexpr double width_per_grain = 128.0 / 1024, lid_mass_per_grain = 100.0 / 1024;

dem::State lattice(std::size_t grains) {
    dem::State s;
    const double width = width_per_grain * static_cast<double>(grains);
    const auto columns = static_cast<std::size_t>(width / 2.03);
    const double spacing = width / static_cast<double>(columns);
    const double row_height = 1.75;
    for (std::uint64_t i = 0; i < grains; ++i) {
        const std::uint64_t row = i / columns;
        const auto v = normal_pair(1, RandomStream::initial_velocity, i);
        s.x.push_back(spacing * (static_cast<double>(i % columns) + (row % 2 ? 0.75 : 0.25)));
        s.y.push_back(2 + row_height * static_cast<double>(row));
        s.vx.push_back(0.1 * v[0]);
        s.vy.push_back(0.1 * v[1]);
    }
    s.lid_height = s.y.back() + 0.5;
    return s;
}

}  // namespace

dem::Parameters bed_parameters(std::size_t grains) {
    const auto n = static_cast<double>(grains);
    dem::Parameters p{.diameter = 2,
                      .mass = 1,
                      .stiffness = 495.96987227912376,
                      .damping = 2.2314355131420975,
                      .gravity = 1,
                      .period_x = width_per_grain * n,
                      .plate_stiffness = 495.96987227912376,
                      .lid = dem::InertialLid{.mass = lid_mass_per_grain * n},
                      .dt = dt};
    p.bottom = dem::MovingPlate{.amplitude = 2, .omega = 2 * std::numbers::pi / shaking_period};
    return p;
}

dem::State fluidised(std::size_t grains) {
    auto p = bed_parameters(grains);
    p.scheme = dem::Scheme::verlet_predicted;
    p.dt = 2 * dt;
    const dem::State start = lattice(grains);
    if (!dem::why_not_simd(p, start)) p.precision = dem::Precision::mixed;
    dem::Engine engine(p, start);
    engine.advance(std::lround(start_time / p.dt));
    dem::State s = engine.state();
    s.step = std::lround(start_time / dt);
    return s;
}

dem::State side_by_side(const dem::State& bed, std::size_t copies) {
    dem::State wide{
        .step = bed.step, .lid_height = bed.lid_height, .lid_velocity = bed.lid_velocity};
    const double width = width_per_grain * static_cast<double>(bed.x.size());
    for (std::size_t copy = 0; copy < copies; ++copy) {
        for (std::size_t i = 0; i < bed.x.size(); ++i) {
            const auto kick = normal_pair(2, RandomStream::initial_velocity, wide.x.size());
            wide.x.push_back(bed.x[i] + width * static_cast<double>(copy));
            wide.y.push_back(bed.y[i]);
            wide.vx.push_back(bed.vx[i] + 1e-3 * kick[0]);
            wide.vy.push_back(bed.vy[i] + 1e-3 * kick[1]);
        }
    }
    return wide;
}

scene::Scene scene_of(const dem::State& s, std::int64_t steps) {
    const std::size_t grains = s.x.size();
    const auto p = bed_parameters(grains);
    scene::Scene scene{.name = fmt::format("bench/bed-{}", grains),
                       .grains = {.diameter = p.diameter, .mass = p.mass},
                       .contact = {.stiffness = p.stiffness, .damping = p.damping},
                       .gravity = p.gravity,
                       .periodic_x = p.period_x,
                       .dt = dt,
                       .steps = steps,
                       .frame_every = steps,
                       .initial = {.x = s.x, .y = s.y, .vx = s.vx, .vy = s.vy}};
    scene.plates = {.stiffness = p.plate_stiffness,
                    .bottom = scene::PrescribedPlate{.amplitude = p.bottom->amplitude,
                                                     .period = shaking_period,
                                                     .phase = start_time / shaking_period},
                    .lid = scene::FreeLid{.mass = lid_mass_per_grain * static_cast<double>(grains),
                                          .height = s.lid_height,
                                          .velocity = s.lid_velocity}};
    return scene;
}

}  // namespace crossgrain::bench
