// Forgiving access to the report document: a missing or null member reads as empty.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace crossgrain::reports {

/// `value` as JSON in valid UTF-8, whatever bytes its texts hold: what is no UTF-8 becomes U+FFFD.
/// Numbers that are not finite become null. `indent` < 0: on one line.
[[nodiscard]] std::string json_text(const nlohmann::json& value, int indent = 2);

/// The array at `key`, or an empty one.
[[nodiscard]] const nlohmann::json& list_at(const nlohmann::json& object, const char* key);

/// The text at `key`, or "".
[[nodiscard]] std::string text_at(const nlohmann::json& object, const char* key);

/// The number at `key` in the shortest form that reads back as the same number, or "" when it is
/// missing or not finite.
[[nodiscard]] std::string number_at(const nlohmann::json& object, const char* key);

}  // namespace crossgrain::reports
