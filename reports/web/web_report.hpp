// Writes the static report pages: copies the page assets and puts the data document beside them.
//
// The pages are opened from the file system, where a browser may not fetch JSON; the document is
// therefore embedded in a classic script, `data.js`, that assigns `window.crossgrainReport`.
// The schema of the document is in reports/web/README.md. Nothing is computed here or in the pages
// beyond formatting: what is not in the document is shown as missing.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace crossgrain::reports {

/// Writes index.html, history.html, their scripts and style, Plotly and data.js to `directory`
/// (created when needed). `assets` is the folder assembled by the build target `web_assets`
/// (share/crossgrain/web). data.js is written last and by rename: pages never see half a document.
/// @throws CaseError when `assets` lacks a page or Plotly,
///         std::system_error when `directory` cannot be written.
void write_web_report(const nlohmann::json& document, const std::filesystem::path& directory,
                      const std::filesystem::path& assets);

/// The text of data.js: pure ASCII and without `<`, so that neither a `</script>` in a log tail nor
/// a U+2028 nor a broken byte sequence can end the script early, even when pasted into a page.
/// Numbers that are not finite become null.
[[nodiscard]] std::string data_script(const nlohmann::json& document);

}  // namespace crossgrain::reports
