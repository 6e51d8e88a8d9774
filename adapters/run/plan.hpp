// Which runs a case needs: variants x time steps x replicas x codes.
#pragma once

#include "adapters/code.hpp"
#include "adapters/run/settings.hpp"
#include "adapters/run/store/store.hpp"
#include "cases/catalog/case.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace crossgrain::run {

struct PlannedRun {
    const catalog::Case* owner = nullptr;
    const adapters::Code* code = nullptr;
    std::shared_ptr<const scene::AnyScene> scene;  ///< shared by all codes
    std::size_t variant = 0;
    std::size_t rung = 0;
    std::int64_t replica = 0;
    double time_limit = 0;  ///< wall seconds
    std::string mark;       ///< tells runs of the same name apart, in directories and progress
    /// Everything but the results: key, names, settings; status is "planned", or says why there is
    /// nothing to run ("not_installed", "not_expressible").
    store::RunRecord record;
};

/// Only codes that run the case's model take part; throws CaseError if none of those asked for
/// does, and Interrupted. Replicas of a code share their seeds with the other codes: replica r has
/// seed + r.
[[nodiscard]] std::vector<PlannedRun> plan(const catalog::Case& the_case,
                                           const std::vector<const adapters::Code*>& codes,
                                           const Settings& settings,
                                           const std::stop_token& stop = {});

/// SHA-256 over all that decides the run's numbers: scene, input files, observables, the code, its
/// version and its program, and of our own sources those of the code and of the case's estimators
/// with what they include.
[[nodiscard]] std::string run_key(const PlannedRun& run);

/// SHA-256 over what decides the frames that the code yields: all of the above but the observables
/// and the estimators. `ready`: the scene as the run starts from it.
[[nodiscard]] std::string frames_key(const PlannedRun& run, const scene::AnyScene& ready);

}  // namespace crossgrain::run
