#include "tests/bench/bench_dem_accuracy.hpp"

#include "native/base/cpu_time.hpp"
#include "native/base/errors.hpp"
#include "native/base/random.hpp"
#include "native/dem/engine.hpp"
#include "tests/bench/bench_dem_bed.hpp"
#include "tests/bench/bench_round.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain::bench {
namespace {

/// Restitution of two grains, averaged over the moment of contact within a step, against 0.8.
double restitution_error(dem::Scheme scheme, double step) {
    constexpr double exact = 0.8, contact_time = 0.1;
    constexpr int entries = 16, steps = 9;
    double sum = 0;
    for (int n = 0; n < entries * steps; ++n) {
        auto p = bed_parameters(2);
        p = {.diameter = p.diameter,
             .mass = p.mass,
             .stiffness = p.stiffness,
             .damping = p.damping,
             .scheme = scheme,
             .dt = step * (0.96 + 0.01 * (n % steps))};
        const int entry = n / steps;
        const double half = p.diameter / 2 + p.dt / 2 * (entry + 0.5) / entries;
        dem::Engine engine(p, {.x = {-half, half}, .y = {0, 0}, .vx = {0.5, -0.5}, .vy = {0, 0}});
        engine.advance(std::lround(2 * contact_time / p.dt) + 4);
        sum += engine.state().vx[1] - engine.state().vx[0];
    }
    return std::abs(sum / (entries * steps) / exact - 1);
}

constexpr double lattice_time = 3;
constexpr std::uint64_t lattice_columns = 64, lattice_rows = 20;

/// Taguchi's section 3: bottom and lid in phase, no gravity. Returns the mean of v_x^2 at t = 3, in
/// the middle of what Fig. 7 shows, and adds to `cpu_s`.
double lattice_shake(dem::Scheme scheme, double step, std::uint64_t seed, double& cpu_s) {
    auto p = bed_parameters(1024);
    p.gravity = 0;
    p.bottom->amplitude = 1;
    const double row_height = std::sqrt(3.0);
    p.lid = dem::MovingPlate{
        .height = row_height * (lattice_rows - 1), .amplitude = 1, .omega = p.bottom->omega};
    p.scheme = scheme;
    const auto steps = std::lround(lattice_time / step);
    p.dt = lattice_time / static_cast<double>(steps);
    dem::State s;
    for (std::uint64_t i = 0; i < lattice_columns * lattice_rows; ++i) {
        const std::uint64_t row = i / lattice_columns;
        const auto v = normal_pair(seed, RandomStream::initial_velocity, i);
        s.x.push_back(p.diameter * static_cast<double>(i % lattice_columns) +
                      (row % 2 ? 1.5 : 0.5));
        s.y.push_back(1 + row_height * static_cast<double>(row));
        s.vx.push_back(0.1 * v[0]);
        s.vy.push_back(0.1 * v[1]);
    }
    const double start = process_cpu_seconds();
    dem::Engine engine(p, s);
    engine.advance(steps);
    cpu_s += process_cpu_seconds() - start;
    double sum = 0;
    for (const double v : engine.state().vx)
        sum += v * v;
    return sum / static_cast<double>(engine.state().vx.size());
}

constexpr std::uint64_t lattice_seeds = 4;

/// Root mean square, over the seeds, of the relative error of that mean, and the CPU seconds of
/// one.
std::pair<double, double> lattice_error(dem::Scheme scheme, double step,
                                        const std::vector<double>& truth) {
    double squares = 0, cpu_s = 0;
    for (std::uint64_t seed = 0; seed < lattice_seeds; ++seed) {
        const double error = lattice_shake(scheme, step, seed, cpu_s) / truth[seed] - 1;
        squares += error * error / lattice_seeds;
    }
    return {std::sqrt(squares), cpu_s / lattice_seeds};
}

}  // namespace

void bench_accuracy(BenchReport& report, const BenchOptions& options) {
    constexpr double contact_time = 0.1;
    std::vector<double> truth;
    double cpu_of_truth = 0;
    for (std::uint64_t seed = 0; seed < lattice_seeds; ++seed) {
        truth.push_back(
            lattice_shake(dem::Scheme::verlet_predicted, contact_time / 2000, seed, cpu_of_truth));
    }
    const std::pair<const char*, dem::Scheme> schemes[] = {
        {"to accuracy: native, Verlet with predicted velocity", dem::Scheme::verlet_predicted},
        {"to accuracy: native, Verlet with half-step velocity", dem::Scheme::verlet_half_step},
        {"to accuracy: native, the paper's Euler", dem::Scheme::taguchi_euler}};
    const double sizes[] = {0.2, 0.1, 0.07, 0.05, 0.03, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005};
    for (const auto& [name, scheme] : schemes) {
        for (const double size : sizes) {
            if (options.stop.stop_requested()) throw Interrupted();
            const double step = size * contact_time;
            const double e_error = restitution_error(scheme, step);
            if (e_error > 0.01) continue;
            const auto [error, cpu_s] = lattice_error(scheme, step, truth);
            if (error > 0.02) continue;
            report.rows.push_back(
                {.name = name,
                 .size = lattice_columns * lattice_rows,
                 .rate = 1 / cpu_s,
                 .unit = "lattice transients/cpu-s",
                 .details = {{"dt/t_col", fmt::format("{:g}", size)},
                             {"cpu seconds", fmt::format("{:.3g}", cpu_s)},
                             {"error of e", fmt::format("{:.2g} %", 100 * e_error)},
                             {"error of the transient", fmt::format("{:.2g} %", 100 * error)}}});
            if (options.progress) {
                options.progress(
                    fmt::format("{}: dt = {:g} t_col, {:.3g} CPU seconds", name, size, cpu_s));
            }
            break;
        }
    }
    // LAMMPS has the half-step velocity; its steps cost what they cost in the bed.
    const auto* half_step = find(report, schemes[1].first, lattice_columns * lattice_rows);
    const auto* lammps_row = find(report, "lammps", 1024);
    if (!half_step || !lammps_row) return;
    const double size = std::stod(half_step->details.at("dt/t_col"));
    const double steps = lattice_time / (size * contact_time);
    const double cpu_s =
        steps * static_cast<double>(lattice_columns * lattice_rows) / lammps_row->rate;
    report.rows.push_back({.name = "to accuracy: lammps",
                           .size = lattice_columns * lattice_rows,
                           .rate = 1 / cpu_s,
                           .unit = "lattice transients/cpu-s",
                           .details = {{"dt/t_col", fmt::format("{:g}", size)},
                                       {"cpu seconds", fmt::format("{:.3g}", cpu_s)},
                                       {"step", "at its rate in the bed of 1024 grains"}}});
}

}  // namespace crossgrain::bench
