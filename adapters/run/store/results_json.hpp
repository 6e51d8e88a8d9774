// Results of a run <-> JSON, for the store and the report.
#pragma once

#include "cases/measure/results.hpp"

#include <nlohmann/json_fwd.hpp>

namespace crossgrain::store {

[[nodiscard]] nlohmann::json to_json(const measure::Results& results);
/// Inverse of to_json; results of older programs have no pictures and no findings. Throws
/// nlohmann::json::exception for anything else, std::invalid_argument for damaged pixels.
[[nodiscard]] measure::Results results_from_json(const nlohmann::json& json);

/// {name, title, width, height, palette: [[r, g, b]], pixels}, pixels as in packed_bytes.hpp.
[[nodiscard]] nlohmann::json picture_to_json(const measure::Picture& picture);
/// Inverse of picture_to_json; throws like results_from_json.
[[nodiscard]] measure::Picture picture_from_json(const nlohmann::json& json);

}  // namespace crossgrain::store
