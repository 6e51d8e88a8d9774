// A report document in the parts the pages load one by one: what every reader sees, the history,
// and per case the curves and pictures that are looked at when a reader asks for them.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace crossgrain::reports {

struct DocumentParts {
    /// The document without its history; in each case `pictures` name their `file` instead of
    /// holding pixels, `series` has only what the sections of the page draw, `series_file` and
    /// `series_names` tell where the others are.
    nlohmann::json overview;
    nlohmann::json history;  ///< {"history": ...}
    /// Path below the report's folder, bytes: pictures/*.png and series/*.js.
    std::vector<std::pair<std::filesystem::path, std::string>> files;
};

/// A picture whose parts do not fit together gets a `problem` instead of a `file`.
[[nodiscard]] DocumentParts split(nlohmann::json document);

/// A script that assigns `value` to `target`: pure ASCII and without `<`, so that neither a
/// `</script>` in a log tail nor a U+2028 nor a broken byte sequence can end it early, even when
/// pasted into a page. Numbers that are not finite become null.
[[nodiscard]] std::string script(const std::string& target, const nlohmann::json& value);

}  // namespace crossgrain::reports
