#include "app/pages.hpp"

#include "app/output.hpp"
#include "reports/web/atomic_file.hpp"
#include "reports/web/document.hpp"
#include "reports/web/web_report.hpp"

#include <nlohmann/json.hpp>

namespace crossgrain::app {
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

std::filesystem::path page_file(Page page, const Settings& settings) {
    auto file = settings.results / "report" / stem_of(page);
    file += has_pages ? ".html" : ".json";
    return file;
}

void write_page(Page page, const nlohmann::json& document, const Settings& settings) {
    if (!has_pages) {
        const auto file = page_file(page, settings);
        if (!settings.quiet) {
            print_note("this build has no pages (CROSSGRAIN_PAGES=OFF): {} has their data",
                       file.string());
        }
        reports::remove_unfinished_files(file.parent_path());
        reports::write_file_atomically(file, reports::json_text(document, 1) + "\n");
        return;
    }
    const auto directory = settings.results / "report";
    const auto assets = share_directory() / "web";
    switch (page) {
    case Page::report:
        return reports::write_web_report(document, directory, assets);
    case Page::charts:
        return reports::write_chart_page(document, directory, assets);
    case Page::stability:
        return reports::write_stability_page(document, directory, assets);
    }
}

}  // namespace crossgrain::app
