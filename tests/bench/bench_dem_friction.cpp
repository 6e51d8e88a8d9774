// crossgrain bench dem-friction: rotating grains with friction in a dilute pipe and in a dense
// hopper, from the same state on, native and in the other codes, each in the conventions of its own
// law.
#include "adapters/lammps/lammps_code.hpp"
#include "adapters/liggghts/liggghts_code.hpp"
#include "adapters/native/native_dem_code.hpp"
#include "adapters/yade/yade_code.hpp"
#include "tests/bench/bench.hpp"
#include "tests/bench/bench_friction_scenes.hpp"
#include "tests/bench/bench_programs.hpp"
#include "tests/bench/bench_round.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace crossgrain::bench {
namespace {

/// A code and one of its laws.
struct Law {
    std::string name;
    const adapters::GrainCode* code = nullptr;
    const char* conventions = nullptr;  ///< see scene::conventions_named
    /// Of dashpots: some laws know only this one.
    scene::DampingScale scale = scene::DampingScale::absolute;
    double share = 1;  ///< of the steps of the native engine that it is given
    int every = 1;     ///< takes part in every so many turns
};

/// The scene in the words of this law; for unit masses all are the same.
scene::Scene asked_of(const Law& law, scene::Scene s, std::int64_t steps) {
    s.steps = s.frame_every = steps;
    s.contact.friction->conventions = scene::conventions_named(law.conventions);
    s.contact.damping_scale = law.scale;
    // Per unit of the effective mass, 1/2.
    if (law.scale == scene::DampingScale::effective_mass) s.contact.damping *= 2;
    return s;
}

Contender contender(const Law& law, const scene::Scene& s, const BenchOptions& options) {
    const std::size_t grains = mobile_grains(s);
    const SceneOf asked = [law, s](std::int64_t steps) { return asked_of(law, s, steps); };
    Contender c = law.code->name() == "lammps"
                      ? lammps(options, asked, grains, 1, law.share, law.every)
                      : program(*law.code, options, asked, grains, law.share, law.every);
    c.name = law.name;
    c.details = {{"conventions", law.conventions}};
    return c;
}

/// All laws on one scene, those that are not here or cannot express it told in the notes.
void bench_scene(const std::string& name, const scene::Scene& s, std::int64_t steps,
                 std::vector<Law> laws, const BenchOptions& options, BenchReport& report) {
    const auto grains = static_cast<std::int64_t>(mobile_grains(s));
    Round round(options, steps, options.quick ? 2 : 10);
    for (Law& law : laws) {
        law.name += ", " + name;
        if (const auto reason = cannot_take_part(*law.code, asked_of(law, s, 1))) {
            report.notes.push_back(fmt::format("{}: {}", law.name, *reason));
        } else {
            round.add(contender(law, s, options));
        }
    }
    round.run(report);
    const std::string native = laws.front().name;
    for (const Law& law : laws) {
        if (law.code->name() != "lammps") continue;
        add_target(report, fmt::format("native over {}", law.name), find(report, native, grains),
                   find(report, law.name, grains), 4);
    }
    std::vector<std::string> others;
    std::transform(laws.begin() + 1, laws.end(), std::back_inserter(others),
                   [](const Law& law) { return law.name; });
    tell_ratios(report, others);
}

}  // namespace

BenchReport bench_dem_friction(const BenchOptions& options) {
    const adapters::NativeDemCode native("bench");
    const adapters::LammpsCode lammps_code;
    const adapters::LiggghtsCode liggghts;
    const adapters::YadeCode yade;
    const std::vector<Law> laws{
        {.name = "native", .code = &native, .conventions = "liggghts"},
        {.name = "lammps granular", .code = &lammps_code, .conventions = "lammps-granular"},
        {.name = "lammps hooke/history",
         .code = &lammps_code,
         .conventions = "lammps-hooke-history",
         .scale = scene::DampingScale::effective_mass},
        {.name = "liggghts",
         .code = &liggghts,
         .conventions = "liggghts",
         .share = 0.5,
         .every = 2},
        {.name = "yade", .code = &yade, .conventions = "yade", .share = 0.2, .every = 5}};
    BenchReport report;
    bench_scene("pipe", pipe_of_grains(), options.quick ? 40000 : 100000, laws, options, report);
    const auto filled = hopper_of_grains(options.quick ? 40 : 100);
    bench_scene("hopper", filled, options.quick ? 4000 : 2500, laws, options, report);
    return report;
}

}  // namespace crossgrain::bench
