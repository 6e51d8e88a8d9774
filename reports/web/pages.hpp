// The report pages, which a build may leave out (CMake option CROSSGRAIN_PAGES): only they need
// npm.
#pragma once

#include "adapters/run/settings.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace crossgrain::reports {

enum class Page { report, charts, stability };

/// The file to look at once the page has been written: <results>/report/index.html, charts.html or
/// stability.html; without pages the document itself: report.json, charts.json or stability.json.
[[nodiscard]] std::filesystem::path page_file(Page page, const run::Execution& settings);

/// Writes page_file(), and with pages all that it needs. Without them it says so in one line
/// to the monitor. Throws CaseError when the parts of the pages are not beside
/// the program, std::system_error when the directory cannot be written.
void write_page(Page page, const nlohmann::json& document, const run::Execution& settings);

}  // namespace crossgrain::reports
