// crossgrain advise: from the store alone; what is missing is said, with what it will cost.
#include "adapters/registry/codes.hpp"
#include "adapters/run/expected_cost.hpp"
#include "adapters/run/plan.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "app/progress.hpp"
#include "native/base/errors.hpp"
#include "native/base/machine.hpp"
#include "reports/session/session.hpp"
#include "reports/studies/chart/advise.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace crossgrain::app {
namespace {

using nlohmann::json;

std::string way(const studies::ChartPoint& point) {
    return point.variant.empty() ? point.code : fmt::format("{} {}", point.code, point.variant);
}

std::string text_of(const studies::Advice& advice) {
    std::string text = fmt::format("{} within {:g}:\n", advice.observable, advice.tolerance);
    if (const auto& best = advice.cheapest) {
        text += fmt::format("  enough: {}, {} run{}, {:.3g} CPU s; bias {:.2g} +- {:.1g}, scatter "
                            "of a run {:.2g}\n",
                            way(best->point), best->runs, best->runs == 1 ? "" : "s", best->cpu_s,
                            best->point.bias, best->point.bias_stderr, best->point.scatter);
    } else {
        text += fmt::format("  none: {}\n", advice.reason);
    }
    if (const auto& less = advice.next_cheaper) {
        text += fmt::format("  not enough: {}, {:.3g} CPU s a run: {} {:.2g} +- {:.1g}\n",
                            way(less->point), less->cpu_s,
                            less->wrong ? "off by" : "too uncertain to say, off by",
                            less->point.bias, less->point.bias_stderr);
    }
    for (const auto& d : advice.dropped) {
        text +=
            fmt::format("  without {} ({}): {} (difference {:.2g} +- {:.1g}), costs {:.2g} "
                        "times as much\n",
                        d.drops, d.variant, d.verdict, d.difference, d.half_width, d.cost_ratio);
    }
    return text;
}

json point_json(const studies::ChartPoint& point) {
    return {{"code", point.code},
            {"variant", point.variant},
            {"bias", point.bias},
            {"bias_stderr", point.bias_stderr},
            {"scatter", point.scatter}};
}

json json_of(const studies::Advice& advice) {
    json result{{"observable", advice.observable},
                {"tolerance", advice.tolerance},
                {"enough", nullptr},
                {"not_enough", nullptr},
                {"dropped", json::array()},
                {"reason", advice.reason}};
    if (const auto& best = advice.cheapest) {
        result["enough"] = point_json(best->point);
        result["enough"].update({{"runs", best->runs}, {"cpu_s", best->cpu_s}});
    }
    if (const auto& less = advice.next_cheaper) {
        result["not_enough"] = point_json(less->point);
        result["not_enough"].update({{"cpu_s", less->cpu_s}, {"wrong", less->wrong}});
    }
    for (const auto& d : advice.dropped) {
        result["dropped"].push_back({{"drops", d.drops},
                                     {"variant", d.variant},
                                     {"difference", d.difference},
                                     {"half_width_95", d.half_width},
                                     {"verdict", d.verdict},
                                     {"cost_ratio", d.cost_ratio}});
    }
    return result;
}

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
            if (item.runs.records()[i++].status != "not_run") continue;
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
        print_note("error: {} runs of the chart are not in the store; run 'crossgrain chart {}' "
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
        answers.push_back(json_of(advice));
        if (!settings.json) print_result_text(text_of(advice));
    }
    if (answers.empty()) throw unknown_observable(chart, request.observable);
    if (settings.json) print_document({{"case", chart.case_name}, {"advice", answers}});
    return enough ? exit_ok : exit_verdict;
}

}  // namespace crossgrain::app
