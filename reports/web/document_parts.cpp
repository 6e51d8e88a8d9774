#include "reports/web/document_parts.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include <fmt/format.h>

#include "adapters/run/store/results_json.hpp"
#include "reports/documents/json_text.hpp"
#include "reports/web/file_names.hpp"
#include "reports/web/png.hpp"

namespace crossgrain::reports {
namespace {

using Json = nlohmann::json;

struct Names {
    FileNames pictures, series;
};

/// Pixels become a file; what cannot become one says why.
void move_picture(const std::string& case_name, Json& picture, Names& names, DocumentParts& parts) {
    if (!picture.is_object()) return;
    try {
        std::string bytes = png_bytes(store::picture_from_json(picture));
        const std::string file =
            names.pictures.next({case_name, text_at(picture, "code"), text_at(picture, "variant"),
                                 text_at(picture, "name")},
                                ".png");
        picture["file"] = "pictures/" + file;
        parts.files.emplace_back("pictures/" + file, std::move(bytes));
    } catch (const Json::exception& error) {
        picture["problem"] = error.what();
    } catch (const std::invalid_argument& error) {
        picture["problem"] = error.what();
    }
    picture.erase("pixels");
    picture.erase("palette");
}

/// Series that have a section of their own on the page (schema in reports/web/README.md).
bool has_section(const Json& series) {
    const std::string name = text_at(series, "name");
    const auto has = [&](const char* column) {
        return std::ranges::count(list_at(series, "columns"), Json(column)) > 0;
    };
    return (name == "lid-height" && has("h")) || (name == "spectrum" && has("K")) ||
           (name == "spectrum-fit" && has("layer_first")) ||
           (name == "convergence" && has("rms_error"));
}

void move_series(const std::string& case_name, Json& item, Names& names, DocumentParts& parts) {
    Json kept = Json::array();
    Json moved = Json::array();
    std::map<std::string, int> counts;
    for (auto& series : item["series"]) {
        const bool keep = has_section(series);
        if (!keep) ++counts[text_at(series, "name")];
        (keep ? kept : moved).push_back(std::move(series));
    }
    item["series"] = std::move(kept);
    if (moved.empty()) return;
    const std::string file = "series/" + names.series.next({case_name}, ".js");
    item["series_file"] = file;
    item["series_names"] = counts;
    parts.files.emplace_back(
        file, script(fmt::format("(window.crossgrainSeries ||= {{}})[\"{}\"]", file), moved));
}

}  // namespace

DocumentParts split(nlohmann::json document) {
    DocumentParts parts;
    if (document.is_object()) {
        parts.history = {{"history", document.value("history", Json::object())}};
        document.erase("history");
        Names names;
        if (const auto cases = document.find("cases"); cases != document.end()) {
            for (auto& item : *cases) {
                if (!item.is_object()) continue;
                const std::string name = text_at(item, "case");
                if (item.contains("pictures") && item["pictures"].is_array()) {
                    for (auto& picture : item["pictures"])
                        move_picture(name, picture, names, parts);
                }
                if (item.contains("series") && item["series"].is_array())
                    move_series(name, item, names, parts);
            }
        }
    }
    parts.overview = std::move(document);
    return parts;
}

std::string script(const std::string& target, const nlohmann::json& value) {
    // Log tails of foreign programs may hold any bytes: replaced by U+FFFD instead of an exception.
    const std::string json = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    std::string text = target + " = ";
    text.reserve(text.size() + json.size() + json.size() / 64);
    for (const char c : json) {
        // Outside strings JSON has no '<', so the escape is always inside one.
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    text += ";\n";
    return text;
}

}  // namespace crossgrain::reports
