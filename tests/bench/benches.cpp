#include "cases/toml/toml_table.hpp"
#include "native/base/errors.hpp"
#include "tests/bench/bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

const Bench& bench_named(const std::string& name) {
    std::vector<std::string> known;
    for (const auto& bench : benches()) {
        if (bench.name == name) return bench;
        known.push_back(bench.name);
    }
    const auto near = toml_input::nearest(name, known);
    throw CaseError({.problem = "unknown bench",
                     .got = fmt::format("'{}'", name),
                     .expected = fmt::format("one of {}", fmt::join(known, ", ")),
                     .hint = near ? fmt::format("did you mean '{}'?", *near) : ""});
}

}  // namespace crossgrain::bench
