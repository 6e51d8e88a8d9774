// crossgrain chart: runs the ladders of cases, and writes what they cost against how far they are
// off as JSON, CSV and a page.
#include "app/catalogue/catalogue.hpp"
#include "app/chart/chart_document.hpp"
#include "app/commands/commands.hpp"
#include "app/session.hpp"
#include "reports/web/atomic_file.hpp"
#include "reports/web/web_report.hpp"

#include <fmt/format.h>

namespace crossgrain::app {

int chart_cases(const Settings& given, std::stop_token stop) {
    Settings settings = given;
    settings.suite = catalog::Suite::chart;
    store::Store store = open_store(settings, store::Access::write);
    const auto report = run_session(settings, store, std::move(stop), true);
    nlohmann::json charts = nlohmann::json::array();
    const auto directory = settings.results / "report";
    for (const auto& item : report.cases) {
        const Chart chart = chart_of(item);
        charts.push_back(chart_json(chart));
        charts.back()["created"] = store::utc_now();
        charts.back()["version"] = program_version();
        reports::write_file_atomically(directory / "charts" / (chart.case_name + ".csv"),
                                       chart_csv(chart));
        reports::write_file_atomically(directory / "charts" / (chart.case_name + ".json"),
                                       charts.back().dump(1) + "\n");
        if (!settings.json) fmt::print("{}\n", chart_table(chart));
    }
    const Machine machine = this_machine();
    const nlohmann::json document{{"version", program_version()},
                                  {"created", store::utc_now()},
                                  {"command", settings.command},
                                  {"machine", {{"cpu", machine.cpu}, {"cores", machine.cores}}},
                                  {"charts", charts}};
    // Before the page, which a file of another call can spoil: what was computed is told.
    if (settings.json) fmt::print("{}\n", document.dump(2));
    nlohmann::json page = document;
    add_earlier_charts(directory / "charts", page["charts"]);
    reports::write_chart_page(page, directory, share_directory() / "web");
    if (!settings.json) fmt::print("written: {}\n", (directory / "charts.html").string());
    // A rung that fails is a result here; a run that nobody let finish is not.
    return report.interrupted ? exit_interrupted : exit_ok;
}

}  // namespace crossgrain::app
