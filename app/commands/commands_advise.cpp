// crossgrain advise: from the store alone; what is missing is said, with what it will cost.
#include "adapters/registry/codes.hpp"
#include "adapters/run/expected_cost.hpp"
#include "adapters/run/plan.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "native/base/errors.hpp"
#include "native/base/machine.hpp"
#include "reports/session/session.hpp"
#include "reports/studies/chart/advise.hpp"
#include "reports/terminal/output.hpp"
#include "reports/terminal/progress.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace crossgrain::app {
namespace {

using nlohmann::json;

/// What "crossgrain chart" would still have to run, and how long.
struct Missing {
    std::size_t runs = 0;
    double cpu_s = 0;
};

Missing missing_runs(const session::SessionReport& report, const Settings& settings) {
    Missing missing;
    const auto codes = adapters::select_codes(settings.codes);
    for (const auto& item : report.cases) {
        std::size_t i = 0;
        for (const auto& run : run::plan(*item.the_case, codes, settings)) {
            if (item.runs.records()[i++].status != store::RunStatus::not_run) continue;
            ++missing.runs;
            missing.cpu_s += run::expected_seconds(run);
        }
    }
    return missing;
}

CaseError unknown_observable(const studies::Chart& chart, const std::string& asked) {
    std::string known;
    for (const auto& o : chart.observables)
        known += (known.empty() ? "" : ", ") + o.observable;
    return CaseError({.key = "--observable",
                      .problem = "is not charted for this case",
                      .got = fmt::format("'{}'", asked),
                      .expected = fmt::format("one of {}, or the beginning of some", known)});
}

}  // namespace

int advise_case(const Settings& given, const AdviseRequest& request) {
    Settings settings = given;
    settings.suite = catalog::Suite::chart;
    store::Store store = session::open_store(settings, store::Access::read);
    const auto report = session::run_session(settings, store, {}, false);
    if (const Missing missing = missing_runs(report, settings); missing.runs > 0) {
        terminal::print_note(
            "error: {} runs of the chart are not in the store; run 'crossgrain chart {}' "
            "first, about {:.0f} s on {} cores",
            missing.runs, settings.cases.front(), missing.cpu_s / this_machine().cores,
            this_machine().cores);
        return exit_run_failed;
    }
    const studies::Chart chart = studies::chart_of(report.cases.front());
    json answers = json::array();
    bool enough = true;
    for (const auto& charted : chart.observables) {
        if (!charted.observable.starts_with(request.observable)) continue;
        const studies::Advice advice = studies::advise(charted, request.tolerance);
        enough = enough && advice.cheapest.has_value();
        answers.push_back(studies::advice_json(advice));
        if (!settings.json) terminal::print_result_text(studies::advice_text(advice));
    }
    if (answers.empty()) throw unknown_observable(chart, request.observable);
    if (settings.json) terminal::print_document({{"case", chart.case_name}, {"advice", answers}});
    return enough ? exit_ok : exit_verdict;
}

}  // namespace crossgrain::app
