// crossgrain bench dem: the same state of the fluidised bed in the native kernels and in the other
// codes, with one state for all that take part.
#include "adapters/lammps/lammps_code.hpp"
#include "adapters/process/find_program.hpp"
#include "native/base/instruction_sets.hpp"
#include "native/dem/engine.hpp"
#include "tests/bench/bench.hpp"
#include "tests/bench/bench_dem_accuracy.hpp"
#include "tests/bench/bench_dem_bed.hpp"
#include "tests/bench/bench_programs.hpp"
#include "tests/bench/bench_round.hpp"
#include "tests/bench/vector_rate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace crossgrain::bench {
namespace {

Turn run_native(dem::Parameters p, const dem::State& s, std::int64_t steps,
                std::int64_t look_every = 0) {
    dem::Engine engine(p, s);
    engine.advance(steps / 10 + 1);
    const auto before = engine.effort();
    const auto cost = timed([&] {
        for (std::int64_t left = steps; left > 0;) {
            const std::int64_t some = look_every > 0 ? std::min(look_every, left) : left;
            engine.advance(some);
            if (look_every > 0) static_cast<void>(engine.state());
            left -= some;
        }
    });
    Turn turn{.cost = cost, .steps = static_cast<double>(steps)};
    const auto after = engine.effort();
    const auto lists = std::max<std::int64_t>(after.neighbour_builds - before.neighbour_builds, 1);
    turn.details = {{"kernel", after.kernel},
                    {"skin", fmt::format("{:.3g}", after.skin)},
                    {"steps per list", fmt::format("{}", steps / lists)}};
    if (after.looked_at > 0) {
        turn.details["neighbours looked at"] = fmt::format("{:.2f}", after.looked_at);
    }
    return turn;
}

Contender native(const dem::State& s, std::string name, dem::Kernel kernel,
                 dem::Precision precision, int threads = 1, std::int64_t look_every = 0,
                 double share = 1) {
    const auto turn = [=, &s](std::int64_t steps) {
        auto p = bed_parameters(s.x.size());
        p.kernel = kernel;
        p.precision = precision;
        p.threads = threads;
        return std::vector{run_native(p, s, steps, look_every)};
    };
    return {std::move(name), particle_steps(s.x.size()), turn, share};
}

/// The same as on a machine without AVX-512.
Contender without_avx512(Contender contender) {
    contender.name += ", AVX2";
    contender.run = [run = std::move(contender.run)](std::int64_t steps) {
        const WithoutAvx512 older;
        return run(steps);
    };
    return contender;
}

constexpr const char* native_double = "native double";
constexpr const char* native_mixed = "native mixed";

void require_over_lammps(BenchReport& report, std::int64_t grains) {
    const auto* lammps_row = find(report, "lammps", grains);
    const auto require = [&](const std::string& name, double at_least) {
        add_target(report, fmt::format("{} over LAMMPS, N = {}", name, grains),
                   find(report, name, grains), lammps_row, at_least);
    };
    require(native_double, has_avx512() ? 9 : 6);
    require(native_mixed, has_avx512() ? 15 : 9);
    require(std::string(native_double) + ", AVX2", 6);
    require(std::string(native_mixed) + ", AVX2", 9);
}

void bench_bed(const BenchOptions& options, const dem::State& state, std::int64_t steps, int turns,
               BenchReport& report) {
    using enum dem::Precision;
    Round round(options, steps, turns);
    round.add(native(state, native_double, dem::Kernel::simd, double_precision));
    round.add(native(state, native_mixed, dem::Kernel::simd, mixed));
    round.add(native(state, "native double, frames", dem::Kernel::simd, double_precision, 1, 100));
    round.add(native(state, "native mixed, frames", dem::Kernel::simd, mixed, 1, 100));
    round.add(native(state, "native scalar", dem::Kernel::scalar, double_precision, 1, 0, 0.3));
    if (has_avx512()) {
        round.add(
            without_avx512(native(state, native_double, dem::Kernel::simd, double_precision)));
        round.add(without_avx512(native(state, native_mixed, dem::Kernel::simd, mixed)));
    }
    add_programs(
        round, options, [&](std::int64_t n) { return scene_of(state, n); }, state.x.size(), report);
    round.run(report);
    const auto grains = static_cast<std::int64_t>(state.x.size());
    require_over_lammps(report, grains);
    for (const char* name : {native_double, native_mixed}) {
        add_target(report, fmt::format("{} with a frame every 100 steps, N = {}", name, grains),
                   find(report, fmt::format("{}, frames", name), grains),
                   find(report, name, grains), 0.9);
    }
}

void bench_wide_bed(const BenchOptions& options, const dem::State& state, std::int64_t steps,
                    BenchReport& report) {
    using enum dem::Precision;
    const auto grains = static_cast<std::int64_t>(state.x.size());
    Round round(options, steps, 5);
    const std::string two = ", 2 threads";
    round.add(native(state, native_double, dem::Kernel::simd, double_precision));
    round.add(native(state, native_double + two, dem::Kernel::simd, double_precision, 2));
    round.add(native(state, native_mixed, dem::Kernel::simd, mixed));
    round.add(native(state, native_mixed + two, dem::Kernel::simd, mixed, 2));
    if (adapters::LammpsCode().probe().installed && adapters::process::find_program("mpirun") &&
        grains <= 100000) {
        round.add(lammps(
            options, [&](std::int64_t n) { return scene_of(state, n); }, state.x.size(), 2, 2, 2));
    }
    round.run(report);
    for (const char* name : {native_double, native_mixed}) {
        const auto* one_thread = find(report, name, grains);
        const auto* two_threads = find(report, name + two, grains);
        add_target(report, fmt::format("{}, N = {} over N = 10000, per core", name, grains),
                   one_thread, find(report, name, 10000), 0.6);
        // Twice the ratio per CPU second: what two threads gain when both have a core.
        add_target(report, fmt::format("{}, two threads over one, N = {}", name, grains),
                   two_threads, one_thread, 1.8, 2);
        add_target(report,
                   fmt::format("{}, two threads over LAMMPS on 2 ranks, N = {}", name, grains),
                   two_threads, find(report, "lammps, 2 ranks", grains), 8);
    }
}

/// The least time that a group and the rows of its list take: instructions that compute, counted in
/// the machine code of the AVX-512 kernels, at the rate at which this processor does such a mix.
/// Every row looked at is loaded and tested, at least one in two also pushes. Lists and branches
/// are not in it.
void tell_ceiling(BenchReport& report) {
    struct Counted {
        const char* name;
        double test, push;  // vector instructions per row
        double group;       // and per group: plates, gravity, kick and drift
        double lanes;
    };
    const double instructions = widest_vector_instructions_per_second();
    for (const Counted c :
         {Counted{native_mixed, 24, 17, 47, 16}, Counted{native_double, 13, 23, 42, 8}}) {
        const auto* row = find(report, c.name, 1024);
        if (!row || row->details.at("kernel").find("AVX3") == std::string::npos) {
            continue;
        }
        const double neighbours = std::stod(row->details.at("neighbours looked at"));
        const double ceiling =
            instructions * c.lanes / (neighbours * (c.test + c.push / 2) + c.group);
        report.notes.push_back(fmt::format(
            "{}: ceiling {:.0f} million particle-steps/s: {:.2f} neighbours looked at, {} vector "
            "instructions to load and test a row of {}, {} more where one touches, {} to move the "
            "grains, {:.2f}e9 instructions per second as measured beside it; reached "
            "{:.0f} % of it",
            c.name, ceiling / 1e6, neighbours, c.test, c.lanes, c.push, c.group, instructions / 1e9,
            100 * row->rate / ceiling));
    }
}

}  // namespace

BenchReport bench_dem(const BenchOptions& options) {
    BenchReport report;
    const dem::State small = fluidised(1024);
    bench_bed(options, small, 4000, options.quick ? 4 : 16, report);
    if (!options.quick) {
        const dem::State medium = fluidised(10000);
        bench_bed(options, medium, 600, 16, report);
        bench_wide_bed(options, side_by_side(medium, 10), 300, report);
        bench_wide_bed(options, side_by_side(medium, 100), 60, report);
        bench_accuracy(report, options);
    }
    tell_ratios(report, {"lammps", "lammps, 2 ranks", "liggghts", "yade"});
    tell_ceiling(report);
    return report;
}

}  // namespace crossgrain::bench
