#include "reports/web/web_report.hpp"

#include <array>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "native/base/errors.hpp"
#include "reports/web/atomic_file.hpp"

namespace crossgrain::reports {
namespace fs = std::filesystem;
namespace {

/// Without these the pages would open blank; every other asset is named by them.
constexpr std::array<std::string_view, 4> required_assets{"index.html", "history.html", "style.css",
                                                          "plotly-cartesian.min.js"};

void check_assets(const fs::path& assets) {
    for (const std::string_view name : required_assets) {
        std::error_code error;
        if (fs::is_regular_file(assets / name, error)) continue;
        throw CaseError({.file = assets.string(),
                         .problem = fmt::format("has no '{}' for the report pages", name),
                         .hint = "build the target web_assets, or install crossgrain completely"});
    }
}

void copy_assets(const fs::path& assets, const fs::path& directory) {
    for (const auto& entry : fs::directory_iterator(assets)) {
        if (!entry.is_regular_file() || entry.path().filename() == "data.js") continue;
        const fs::path target = directory / entry.path().filename();
        std::error_code error;
        fs::copy_file(entry.path(), target, fs::copy_options::overwrite_existing, error);
        if (error)
            throw std::system_error(error, fmt::format("cannot write '{}'", target.string()));
    }
}

}  // namespace

std::string data_script(const nlohmann::json& document) {
    using Json = nlohmann::json;
    // Log tails of foreign programs may hold any bytes: replaced by U+FFFD instead of an exception.
    const std::string json = document.dump(-1, ' ', true, Json::error_handler_t::replace);
    std::string script = "window.crossgrainReport = ";
    script.reserve(script.size() + json.size() + json.size() / 64);
    for (const char c : json) {
        // Outside strings JSON has no '<', so the escape is always inside one.
        if (c == '<')
            script += "\\u003c";
        else
            script += c;
    }
    script += ";\n";
    return script;
}

void write_web_report(const nlohmann::json& document, const fs::path& directory,
                      const fs::path& assets) {
    check_assets(assets);
    std::error_code error;
    fs::create_directories(directory, error);
    if (error)
        throw std::system_error(error,
                                fmt::format("cannot create folder '{}'", directory.string()));
    // A report written where its assets are needs no copies.
    if (!fs::equivalent(assets, directory)) copy_assets(assets, directory);
    write_file_atomically(directory / "data.js", data_script(document));
}

}  // namespace crossgrain::reports
