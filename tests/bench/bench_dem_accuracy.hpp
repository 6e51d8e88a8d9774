// What an accuracy costs: part of `crossgrain bench dem`.
#pragma once

#include "tests/bench/bench.hpp"

namespace crossgrain::bench {

/// CPU seconds until e is right within 1 % and the transient of the lattice (Taguchi, section 3)
/// within 2 %: each scheme at its largest step that is both. LAMMPS is charged what its row of 1024
/// grains in `report` says a step costs.
void bench_accuracy(BenchReport& report, const BenchOptions& options);

}  // namespace crossgrain::bench
