#include "tests/bench/bench_programs.hpp"

#include "adapters/lammps/lammps_code.hpp"
#include "adapters/liggghts/liggghts_code.hpp"
#include "adapters/process/process.hpp"
#include "adapters/process/scratch_directory.hpp"
#include "adapters/process/temporary_base.hpp"
#include "adapters/yade/yade_code.hpp"
#include "native/base/errors.hpp"
#include "reports/documents/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace crossgrain::bench {
namespace {

adapters::process::ScratchDirectory scratch_directory() {
    const auto base = adapters::process::temporary_base();
    adapters::process::sweep(base);
    return {base, "bench"};
}

constexpr double time_limit = 1800;

/// A short run and a long one; `cost` runs a scene.
template <class Cost>
Turn short_and_long(const SceneOf& scene, std::int64_t steps, const Cost& cost) {
    const std::int64_t few = std::max<std::int64_t>(steps / 20, 1);
    return {.cost = cost(scene(few + steps)),
            .start = cost(scene(few)),
            .steps = static_cast<double>(steps)};
}

/// The adapter's own input with another skin, which a later `neighbor` command sets, on so many
/// MPI ranks.
adapters::RunCost run_lammps(const scene::Scene& scene, double skin, int ranks,
                             const std::stop_token& stop) {
    const auto scratch = scratch_directory();
    std::vector<std::string> argv{"lmp", "-log", "none", "-nocite", "-in"};
    for (auto file : adapters::LammpsCode().input(scene)) {
        if (file.name.starts_with("in.")) {
            const auto run = file.text.rfind("\nrun ");
            file.text.insert(run, fmt::format("\nneighbor {:.3g} bin", skin));
            argv.push_back(file.name);
        }
        reports::write_file_atomically(scratch.path() / file.name, file.text);
    }
    if (ranks > 1) {
        argv.insert(argv.begin(), {"mpirun", "--allow-run-as-root", "--oversubscribe", "-np",
                                   std::to_string(ranks)});
    }
    const auto result = adapters::process::run({.argv = argv,
                                                .directory = scratch.path(),
                                                .extra_environment = {"OMP_NUM_THREADS=1"},
                                                .time_limit = time_limit,
                                                .stop = stop});
    if (result.ending == adapters::process::Ending::stopped) throw Interrupted();
    if (result.ending != adapters::process::Ending::exited || result.status != 0) {
        throw std::runtime_error(
            fmt::format("lmp: {}", adapters::process::describe(result, time_limit)));
    }
    return {.cpu_s = result.cpu_s, .wall_s = result.wall_s};
}

}  // namespace

std::optional<std::string> cannot_take_part(const adapters::GrainCode& code,
                                            const scene::Scene& scene) {
    const auto availability = code.probe();
    if (!availability.installed) return availability.reason;
    return code.cannot_express(scene);
}

Work particle_steps(std::size_t grains) {
    return {"particle-steps", static_cast<std::int64_t>(grains), static_cast<double>(grains)};
}

Contender program(const adapters::GrainCode& code, const BenchOptions& options,
                  const SceneOf& scene, std::size_t grains, double share, int every) {
    const auto turn = [&code, scene, stop = options.stop](std::int64_t steps) {
        return std::vector{short_and_long(scene, steps, [&](const scene::Scene& run) {
            const auto scratch = scratch_directory();
            return code.run(run,
                            {.directory = scratch.path(), .time_limit = time_limit, .stop = stop},
                            [](const scene::Frame&) {});
        })};
    };
    return {code.name(), particle_steps(grains), turn, share, every};
}

Contender lammps(const BenchOptions& options, const SceneOf& scene, std::size_t grains, int ranks,
                 double share, int every) {
    const auto with_skin = [scene, stop = options.stop, ranks](std::int64_t steps, double skin) {
        auto turn = short_and_long(scene, steps, [&](const scene::Scene& run) {
            return run_lammps(run, skin, ranks, stop);
        });
        turn.details = {{"skin", fmt::format("{:.3g}", skin)}};
        return turn;
    };
    const auto turn = [with_skin, best = std::make_shared<double>(0)](std::int64_t steps) {
        if (*best > 0) return std::vector{with_skin(steps, *best)};
        const auto net = [](const Turn& t) { return t.cost.cpu_s - t.start.cpu_s; };
        Turn fastest;
        for (const double skin : {0.15, 0.25, 0.35, 0.5, 0.7, 1.0}) {
            Turn tried = with_skin(steps, skin);
            if (*best > 0 && net(tried) >= net(fastest)) continue;
            fastest = std::move(tried);
            *best = skin;
        }
        return std::vector{fastest};
    };
    return {ranks == 1 ? "lammps" : fmt::format("lammps, {} ranks", ranks), particle_steps(grains),
            turn, share, every};
}

void add_programs(Round& round, const BenchOptions& options, const SceneOf& scene,
                  std::size_t grains, BenchReport& report) {
    static const adapters::LammpsCode lammps_code;
    static const adapters::LiggghtsCode liggghts;
    static const adapters::YadeCode yade;
    const auto present = [&](const adapters::GrainCode& code) {
        const auto reason = cannot_take_part(code, scene(1));
        if (reason) report.notes.push_back(fmt::format("{}: {}", code.name(), *reason));
        return !reason;
    };
    if (present(lammps_code)) round.add(lammps(options, scene, grains, 1, 5, 2));
    if (present(liggghts)) round.add(program(liggghts, options, scene, grains, 2, 2));
    if (present(yade)) round.add(program(yade, options, scene, grains, 1, 5));
}

}  // namespace crossgrain::bench
