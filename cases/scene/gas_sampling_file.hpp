// Length, width and the `sample` table of a run that yields GasFrames.
#pragma once

#include "cases/scene/gas_sampling.hpp"
#include "cases/toml/keyed_table.hpp"

#include <vector>

namespace crossgrain::scene {

/// length, width and sample of [scene].
[[nodiscard]] std::vector<toml_input::Key> gas_sampling_keys();

/// `periodic` is left to the caller. Throws CaseError.
[[nodiscard]] GasSampling read_gas_sampling(const toml_input::KeyedTable& scene);

}  // namespace crossgrain::scene
