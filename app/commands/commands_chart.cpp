// crossgrain chart: runs the ladders of cases, and writes what they cost against how far they are
// off as JSON, CSV and a page.
#include "adapters/registry/program_version.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "native/base/machine.hpp"
#include "reports/documents/atomic_file.hpp"
#include "reports/documents/json_text.hpp"
#include "reports/session/session.hpp"
#include "reports/studies/chart/chart_document.hpp"
#include "reports/terminal/output.hpp"
#include "reports/web/pages.hpp"

#include <exception>

namespace crossgrain::app {
namespace {

/// The charts of this call below <directory>/charts, and the page of these and of earlier ones.
void write_charts(const std::vector<studies::Chart>& charts, const nlohmann::json& document,
                  const Settings& settings) {
    const auto directory = settings.results / "report";
    for (std::size_t i = 0; i < charts.size(); ++i) {
        const auto stem =
            (directory / "charts" / studies::chart_stem(charts[i].case_name)).string();
        reports::write_file_atomically(stem + ".csv", studies::chart_csv(charts[i]));
        reports::write_file_atomically(stem + ".json",
                                       reports::json_text(document["charts"][i], 1) + "\n");
    }
    nlohmann::json page = document;
    studies::add_earlier_charts(directory / "charts", page["charts"]);
    reports::write_page(reports::Page::charts, page, settings);
}

}  // namespace

int chart_cases(const Settings& given, std::stop_token stop) {
    Settings settings = given;
    settings.suite = catalog::Suite::chart;
    store::Store store = session::open_store(settings, store::Access::write_later);
    const auto report = session::run_session(settings, store, std::move(stop), true);
    std::vector<studies::Chart> charts;
    nlohmann::json list = nlohmann::json::array();
    for (const auto& item : report.cases) {
        charts.push_back(studies::chart_of(item));
        list.push_back(studies::chart_json(charts.back()));
        list.back()["created"] = store::utc_now();
        list.back()["version"] = adapters::program_version();
    }
    const Machine machine = this_machine();
    const nlohmann::json document{{"version", adapters::program_version()},
                                  {"created", store::utc_now()},
                                  {"command", settings.command},
                                  {"machine", {{"cpu", machine.cpu}, {"cores", machine.cores}}},
                                  {"charts", std::move(list)}};
    // A file of another call can spoil the page; what was computed is told all the same.
    const auto failure = terminal::failure_of([&] { write_charts(charts, document, settings); });
    if (settings.json) {
        terminal::print_document(document);
    } else {
        for (const auto& chart : charts)
            terminal::print_results("{}\n", studies::chart_table(chart));
        if (!failure) {
            terminal::print_results("written: {}\n",
                                    reports::page_file(reports::Page::charts, settings).string());
        }
    }
    if (failure) std::rethrow_exception(failure);
    // A rung that fails is a result here; a run that nobody let finish is not.
    return report.interrupted ? exit_interrupted : exit_ok;
}

}  // namespace crossgrain::app
