#include "reports/web/web_report.hpp"

#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "native/base/errors.hpp"
#include "reports/documents/atomic_file.hpp"
#include "reports/web/document_parts.hpp"

namespace crossgrain::reports {
namespace fs = std::filesystem;
namespace {

/// Without these the pages would open blank; every other asset is named by them.
constexpr std::array<std::string_view, 6> required_assets{"index.html",  "history.html",
                                                          "charts.html", "stability.html",
                                                          "style.css",   "plotly-cartesian.min.js"};

void check_assets(const fs::path& assets) {
    for (const std::string_view name : required_assets) {
        std::error_code error;
        if (fs::is_regular_file(assets / name, error)) continue;
        throw CaseError({.file = assets.string(),
                         .problem = fmt::format("has no '{}' for the report pages", name),
                         .hint = "build the target web_assets, or install crossgrain completely"});
    }
}

bool is_data(const fs::path& path) {
    return path.filename() == "data.js" || path.filename().string().ends_with("-data.js");
}

void copy_assets(const fs::path& assets, const fs::path& directory) {
    for (const auto& entry : fs::directory_iterator(assets)) {
        if (!entry.is_regular_file() || is_data(entry.path())) continue;
        std::ifstream in(entry.path(), std::ios::binary);
        const std::string bytes(std::istreambuf_iterator<char>(in), {});
        if (!in)
            throw std::system_error(EIO, std::generic_category(),
                                    fmt::format("cannot read '{}'", entry.path().string()));
        write_file_atomically(directory / entry.path().filename(), bytes);
    }
}

/// Files of an older report in `folder` that the new one does not have.
void remove_leftovers(const fs::path& folder, const std::string& extension,
                      const std::set<fs::path>& written) {
    std::error_code error;
    std::vector<fs::path> leftovers;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() == extension && !written.contains(entry.path()))
            leftovers.push_back(entry.path());
    }
    // A leftover that stays is no fault of the new report.
    for (const auto& path : leftovers)
        fs::remove(path, error);
}

void prepare(const fs::path& directory, const fs::path& assets) {
    check_assets(assets);
    std::error_code error;
    fs::create_directories(directory, error);
    if (error)
        throw std::system_error(error,
                                fmt::format("cannot create folder '{}'", directory.string()));
    for (const char* folder : {"", "pictures", "series", "charts"})
        remove_unfinished_files(directory / folder);
    // A report written where its assets are needs no copies.
    if (!fs::equivalent(assets, directory)) copy_assets(assets, directory);
}

}  // namespace

void write_web_report(const nlohmann::json& document, const fs::path& directory,
                      const fs::path& assets) {
    prepare(directory, assets);
    const DocumentParts parts = split(document);
    std::set<fs::path> written;
    for (const auto& [file, bytes] : parts.files) {
        write_file_atomically(directory / file, bytes);
        written.insert(directory / file);
    }
    write_file_atomically(directory / "history-data.js",
                          script("window.crossgrainReport", parts.history));
    write_file_atomically(directory / "data.js", script("window.crossgrainReport", parts.overview));
    remove_leftovers(directory / "pictures", ".png", written);
    remove_leftovers(directory / "series", ".js", written);
}

void write_chart_page(const nlohmann::json& document, const fs::path& directory,
                      const fs::path& assets) {
    prepare(directory, assets);
    write_file_atomically(directory / "charts-data.js",
                          script("window.crossgrainReport", document));
}

void write_stability_page(const nlohmann::json& document, const fs::path& directory,
                          const fs::path& assets) {
    prepare(directory, assets);
    write_file_atomically(directory / "stability-data.js",
                          script("window.crossgrainReport", document));
}

}  // namespace crossgrain::reports
