// A dump that was made elsewhere, measured like a run.
#pragma once

#include "adapters/run/settings.hpp"
#include "adapters/run/store/store.hpp"
#include "cases/catalog/case.hpp"
#include "cases/measure/results.hpp"
#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>

namespace crossgrain::run {

/// The numbers of a case from the dump of one of its scenes: the same reader, guard and estimators
/// as of any run. `passed` is called after every frame. Throws TrajectoryError for a dump that is
/// not one of this scene, CaseError if it cannot be opened, Interrupted.
[[nodiscard]] measure::Results measure_frames(const catalog::Case& the_case,
                                              const scene::Scene& scene,
                                              const std::filesystem::path& dump,
                                              const scene::FrameSink& passed,
                                              const std::stop_token& stop);

struct GivenDump {
    std::filesystem::path file;
    std::string name;  ///< of the code that made it
    std::size_t variant = 0, rung = 0;
};

/// Streams the dump through the same guard and the same estimators as any run of the case, which
/// must be one of grains. A dump that is not one of this scene gives a record with the status
/// "run_failed". Throws Interrupted, and what a preparation throws.
[[nodiscard]] store::RunRecord measure_dump(const catalog::Case& the_case, const GivenDump& dump,
                                            const Settings& settings, const std::stop_token& stop);

}  // namespace crossgrain::run
