// The report pages, which a build may leave out (CMake option CROSSGRAIN_PAGES): only they need
// npm.
#pragma once

#include "app/settings.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace crossgrain::app {

enum class Page { report, charts, stability };

/// The file to look at once the page has been written: <results>/report/index.html, charts.html or
/// stability.html; without pages the document itself: report.json, charts.json or stability.json.
[[nodiscard]] std::filesystem::path page_file(Page page, const Settings& settings);

/// Writes page_file(), and with pages all that it needs. Without them it says so in one line on
/// stderr, unless `settings` are quiet. Throws CaseError when the parts of the pages are not beside
/// the program, std::system_error when the directory cannot be written.
void write_page(Page page, const nlohmann::json& document, const Settings& settings);

}  // namespace crossgrain::app
