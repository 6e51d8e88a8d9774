// Results of a run <-> JSON, for the store and the report.
#pragma once

#include "cases/measure/results.hpp"

#include <nlohmann/json_fwd.hpp>

namespace crossgrain::store {

[[nodiscard]] nlohmann::json to_json(const measure::Results& results);
/// Inverse of to_json. Throws nlohmann::json::exception for anything else.
[[nodiscard]] measure::Results results_from_json(const nlohmann::json& json);

}  // namespace crossgrain::store
