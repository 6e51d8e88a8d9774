// The numbers of a report as comma-separated values (RFC 4180), one row each, for other tools.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace crossgrain::reports {

/// A text as one field: quoted if it must be. Spreadsheets take what begins with = + - @ for a
/// formula: such a text gets an apostrophe before it. Numbers do not pass through here. Control
/// characters and bytes that are not UTF-8 are escaped (printable.hpp), but line feeds and tabs.
[[nodiscard]] std::string csv_field(const std::string& given);

/// Columns: case, code, variant, observable, value, stderr, systematic, ci95_low, ci95_high, n,
/// unit, settings ("key=value; ..."). Numbers keep all digits; not finite or missing is empty.
[[nodiscard]] std::string measurements_csv(const nlohmann::json& document);

/// Columns: case, code, against, observable, kind, setting, difference, uncertainty, limit,
/// verdict, expected, reason, limit_reason.
[[nodiscard]] std::string verdicts_csv(const nlohmann::json& document);

}  // namespace crossgrain::reports
