// Forgiving access to the report document: a missing or null member reads as empty.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace crossgrain::reports {

/// The array at `key`, or an empty one.
[[nodiscard]] const nlohmann::json& list_at(const nlohmann::json& object, const char* key);

/// The text at `key`, or "".
[[nodiscard]] std::string text_at(const nlohmann::json& object, const char* key);

/// The number at `key` in the shortest form that reads back as the same number, or "" when it is
/// missing or not finite.
[[nodiscard]] std::string number_at(const nlohmann::json& object, const char* key);

}  // namespace crossgrain::reports
