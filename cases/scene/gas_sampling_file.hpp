// Length, width and the `sample` table of a run that yields GasFrames.
#pragma once

#include "cases/scene/gas_sampling.hpp"
#include "cases/toml/toml_table.hpp"

namespace crossgrain::scene {

/// Keys length, width and sample = { bin, replicas, burn_in, steps, every, fields } of [scene].
/// `periodic` is left to the caller. Throws CaseError.
[[nodiscard]] GasSampling read_gas_sampling(const toml_input::TomlTable& scene);

}  // namespace crossgrain::scene
