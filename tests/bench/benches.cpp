#include "tests/bench/bench.hpp"

namespace crossgrain::bench {

const std::vector<Bench>& benches() {
    static const std::vector<Bench> all{
        {"lga", "lattice gas: site updates per second by word width, against the table engine",
         bench_lga},
        {"hopper", "hopper automaton: grain moves per second, against the plain version",
         bench_hopper},
        {"dem", "distinct elements: particle-steps per second, against LAMMPS, LIGGGHTS and YADE",
         bench_dem},
        {"dem-friction",
         "rotating grains with friction in a pipe and a hopper, against the other three codes",
         bench_dem_friction},
    };
    return all;
}

}  // namespace crossgrain::bench
