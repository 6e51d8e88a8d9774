// Charts as JSON, CSV and text.
#pragma once

#include "reports/studies/chart/chart.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace crossgrain::studies {

/// {case, title, observables: [{observable, against, reason, unit, margin, reference: {value,
/// stderr}, problem, points: [{code, variant, drops, parameters, runs, cpu_s, start_s, value, bias,
/// bias_stderr, scatter, error, accurate, on_front}]}], failures: [{code, variant, status, reason,
/// count}]}; failures of one code with the same reason are one entry.
[[nodiscard]] nlohmann::json chart_json(const Chart& chart);

/// Name of a case's chart files, without extension: the name of the case where it can be one.
[[nodiscard]] std::string chart_stem(const std::string& case_name);

/// Adds the charts that earlier calls left in the directory, by name, to those of this one: an
/// array of charts. Throws CaseError for a file that is none.
void add_earlier_charts(const std::filesystem::path& directory, nlohmann::json& charts);

/// One row per point, columns as in the JSON.
[[nodiscard]] std::string chart_csv(const Chart& chart);

/// The front of every observable, and what failed.
[[nodiscard]] std::string chart_table(const Chart& chart);

}  // namespace crossgrain::studies
