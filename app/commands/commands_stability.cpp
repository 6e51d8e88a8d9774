// crossgrain stability: where methods stop working.
#include "adapters/registry/program_version.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "native/base/machine.hpp"
#include "reports/session/session.hpp"
#include "reports/studies/stability/stability.hpp"
#include "reports/studies/stability/stability_dem.hpp"
#include "reports/studies/stability/stability_map.hpp"
#include "reports/terminal/output.hpp"
#include "reports/web/pages.hpp"

#include <nlohmann/json.hpp>

#include <exception>

namespace crossgrain::app {
namespace {

using nlohmann::json;

/// The page of all maps of this call.
void write_maps(const json& maps, const Settings& settings) {
    const Machine machine = this_machine();
    reports::write_page(reports::Page::stability,
                        {{"version", adapters::program_version()},
                         {"created", store::utc_now()},
                         {"command", settings.command},
                         {"machine", {{"cpu", machine.cpu}, {"cores", machine.cores}}},
                         {"stability", maps}},
                        settings);
}

}  // namespace

int map_stability(const Settings& settings, const std::stop_token& stop) {
    const auto cases = studies::cases_with_thresholds(settings, stop);
    store::Store store = session::open_store(settings, store::Access::write_later);
    std::vector<studies::StabilityReport> reports;
    int code = exit_ok;
    for (const auto& the_case : cases) {
        Settings one = settings;
        one.cases = {studies::map_of(*the_case, settings.map_axes)};
        const bool grains = the_case->model == "grains";
        if (grains) {
            reports.push_back(studies::stability_dem(*the_case, settings, store, stop));
            for (const auto& threshold : reports.back().thresholds) {
                if (!studies::holds_theory(threshold)) code = exit_verdict;
            }
        }
        if (grains && settings.map_axes.empty()) continue;
        for (auto& map : studies::stability_maps(one, store, stop))
            reports.push_back(std::move(map));
    }
    json all = json::array();
    for (const auto& report : reports)
        all.push_back(studies::stability_json(report));
    const auto failure = terminal::failure_of([&] { write_maps(all, settings); });
    if (settings.json) {
        terminal::print_document({{"stability", std::move(all)}});
    } else {
        for (const auto& report : reports)
            terminal::print_result_text(studies::stability_text(report));
        if (!failure) {
            terminal::print_results(
                "written: {}\n", reports::page_file(reports::Page::stability, settings).string());
        }
    }
    if (failure) std::rethrow_exception(failure);
    return stop.stop_requested() ? exit_interrupted : code;
}

}  // namespace crossgrain::app
