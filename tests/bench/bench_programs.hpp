// Foreign codes as contenders of a bench. The time of a short run is taken off that of a long one:
// what is left is steps. So the steps must take much longer than what a start varies by: programs
// are given several times the steps of a kernel that starts at once.
#pragma once

#include "adapters/code.hpp"
#include "tests/bench/bench_round.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace crossgrain::bench {

/// The scene to be run for so many steps.
using SceneOf = std::function<scene::Scene(std::int64_t steps)>;

/// Why the code sits out: not installed, or it cannot express the scene.
[[nodiscard]] std::optional<std::string> cannot_take_part(const adapters::GrainCode& code,
                                                          const scene::Scene& scene);

/// Steps of so many moving grains.
[[nodiscard]] Work particle_steps(std::size_t grains);

/// Every code of ours or others, through its adapter.
[[nodiscard]] Contender program(const adapters::GrainCode& code, const BenchOptions& options,
                                const SceneOf& scene, std::size_t grains, double share, int every);

/// LAMMPS on so many MPI ranks. Tries several skins in its first turn and keeps to the best.
[[nodiscard]] Contender lammps(const BenchOptions& options, const SceneOf& scene,
                               std::size_t grains, int ranks, double share, int every);

/// The programs that are here join the round; of those that are not, why.
void add_programs(Round& round, const BenchOptions& options, const SceneOf& scene,
                  std::size_t grains, BenchReport& report);

}  // namespace crossgrain::bench
