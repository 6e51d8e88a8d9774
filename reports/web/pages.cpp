#include "reports/web/pages.hpp"

#include "native/base/share_directory.hpp"
#include "reports/documents/atomic_file.hpp"
#include "reports/documents/json_text.hpp"
#include "reports/web/web_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace crossgrain::reports {
namespace {

constexpr bool has_pages = CROSSGRAIN_PAGES;

const char* stem_of(Page page) {
    switch (page) {
    case Page::report:
        break;
    case Page::charts:
        return "charts";
    case Page::stability:
        return "stability";
    }
    return has_pages ? "index" : "report";
}

}  // namespace

std::filesystem::path page_file(Page page, const run::Execution& settings) {
    auto file = settings.results / "report" / stem_of(page);
    file += has_pages ? ".html" : ".json";
    return file;
}

void write_page(Page page, const nlohmann::json& document, const run::Execution& settings) {
    if (!has_pages) {
        const auto file = page_file(page, settings);
        settings.monitor->remark(fmt::format(
            "this build has no pages (CROSSGRAIN_PAGES=OFF): {} has their data", file.string()));
        remove_unfinished_files(file.parent_path());
        write_file_atomically(file, json_text(document, 1) + "\n");
        return;
    }
    const auto directory = settings.results / "report";
    const auto assets = share_directory() / "web";
    switch (page) {
    case Page::report:
        return write_web_report(document, directory, assets);
    case Page::charts:
        return write_chart_page(document, directory, assets);
    case Page::stability:
        return write_stability_page(document, directory, assets);
    }
}

}  // namespace crossgrain::reports
