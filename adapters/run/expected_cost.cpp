#include "adapters/run/expected_cost.hpp"

#include <map>
#include <string>

namespace crossgrain::run {
namespace {

struct TypicalCost {
    double start_s;  ///< to start the program
    double rate;     ///< work per CPU second, in the unit of the code's model
};

/// As the benches measure them: particle-steps, site updates, grain moves, counts.
const std::map<std::string, TypicalCost>& typical_costs() {
    static const std::map<std::string, TypicalCost> all{
        {"native-dem", {0.0, 6e7}}, {"lammps", {0.2, 1.1e7}},     {"liggghts", {0.2, 5e6}},
        {"yade", {0.9, 2e6}},       {"native-lga", {0.0, 2.5e9}}, {"native-hopper", {0.0, 5e7}},
        {"synthetic", {0.0, 1e7}},
    };
    return all;
}

}  // namespace

double expected_seconds(const PlannedRun& run) {
    const auto found = typical_costs().find(run.record.code);
    const TypicalCost cost = found == typical_costs().end() ? TypicalCost{1.0, 1e7} : found->second;
    return cost.start_s + run.record.work / cost.rate;
}

}  // namespace crossgrain::run
