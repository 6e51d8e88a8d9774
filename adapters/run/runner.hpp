// Carries out planned runs side by side. Every finished run is stored at once, so that neither an
// interruption nor a failure of another run loses it.
#pragma once

#include "adapters/run/plan.hpp"
#include "adapters/run/settings.hpp"
#include "adapters/run/store/store.hpp"

#include <stop_token>
#include <string>
#include <vector>

namespace crossgrain::run {

struct RunSummary {
    std::vector<store::RunRecord> records;  ///< in the order of the plan
    std::size_t computed = 0;
    std::size_t measured_again = 0;  ///< from kept frames, without starting the code
    std::size_t from_store = 0;
    bool interrupted = false;
    std::string store_error;  ///< first failure to store a result; empty if none
};

/// Runs what the store does not have yet (all if settings.fresh); where an earlier run left the
/// frames (kept_frames.hpp), these are measured and the code is not started. A run that fails gets
/// the status "run_failed" with its reason; the others go on. With `compute` false nothing is run:
/// what the store lacks gets the status "not_run".
[[nodiscard]] RunSummary carry_out(std::vector<PlannedRun> runs, store::Store& store,
                                   const Execution& settings, std::stop_token stop, bool compute);

}  // namespace crossgrain::run
