#include "adapters/run/expected_cost.hpp"

#include "adapters/registry/codes.hpp"

namespace crossgrain::run {

double expected_seconds(const PlannedRun& run) {
    const auto cost = adapters::typical_cost(run.record.code);
    return cost.start_s + run.record.work / cost.rate;
}

}  // namespace crossgrain::run
