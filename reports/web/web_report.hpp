// Writes the static report pages: copies the page assets and puts the data beside them.
//
// The pages are opened from the file system, where a browser may not fetch JSON; the document is
// therefore embedded in classic scripts: `data.js` and `history-data.js` assign
// `window.crossgrainReport`, series/*.js hold the curves of one case each and are loaded when a
// reader asks for them; pictures/*.png are its pictures. The schema of the document is in
// reports/web/README.md. Nothing is computed here or in the pages beyond formatting: what is not in
// the document is shown as missing.
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

namespace crossgrain::reports {

/// Writes index.html, history.html, their scripts and style, Plotly and the data to `directory`
/// (created when needed). `assets` is the folder assembled by the build target `web_assets`
/// (share/crossgrain/web). data.js is written last and every file by rename: pages never see half a
/// document. Pictures and series of an older report in `directory` are removed.
/// @throws CaseError when `assets` lacks a page or Plotly,
///         std::system_error when `directory` cannot be written.
void write_web_report(const nlohmann::json& document, const std::filesystem::path& directory,
                      const std::filesystem::path& assets);

/// Writes charts.html with its data, and what it shares with the other pages. Throws as above.
void write_chart_page(const nlohmann::json& document, const std::filesystem::path& directory,
                      const std::filesystem::path& assets);

/// Writes stability.html likewise.
void write_stability_page(const nlohmann::json& document, const std::filesystem::path& directory,
                          const std::filesystem::path& assets);

}  // namespace crossgrain::reports
