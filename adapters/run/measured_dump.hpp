// A dump that was made elsewhere, measured like a run.
#pragma once

#include "adapters/run/settings.hpp"
#include "adapters/run/store/store.hpp"

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>

namespace crossgrain::run {

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
