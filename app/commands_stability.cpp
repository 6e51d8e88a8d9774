// crossgrain stability: where methods stop working. For distinct elements thresholds by bisection;
// for the lattice models the states their runs were found in, over the sweep of a case or of the
// failure map it names.
#include "app/commands.hpp"
#include "app/session.hpp"
#include "app/stability.hpp"
#include "app/stability_dem.hpp"
#include "app/text_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace crossgrain::app {
namespace {

using nlohmann::json;

bool holds_theory(const StabilityThreshold& threshold) {
    return !threshold.theory ||
           std::abs(threshold.measured() / *threshold.theory - 1) <= threshold.tolerance;
}

/// The state a run was found in, or why there is none.
StabilityPoint point_of(const catalog::Variant& variant, const store::RunRecord& run) {
    StabilityPoint point{.code = run.code, .state = run.status, .detail = run.reason};
    // A trajectory that left all bounds is what a map looks for.
    if (run.status == "run_failed") {
        const bool limited = run.reason.find("time limit") != std::string::npos;
        point.state = limited ? "not finished" : "blow-up";
    }
    for (const auto& [key, value] : variant.parameters) {
        try {
            point.at[key] = std::stod(value);
        } catch (const std::invalid_argument&) {
            point.in[key] = value;
        }
    }
    if (variant.parameters.empty()) point.in["variant"] = variant.name;
    for (const auto& finding : run.results.findings) {
        if (finding.name != "state") continue;
        point.state = finding.label;
        point.detail = finding.detail;
    }
    return point;
}

StabilityReport states_of(const CaseReport& item) {
    StabilityReport report{.case_name = item.the_case->name};
    for (const auto& variant : item.the_case->variants) {
        for (const auto& run : item.runs.records()) {
            if (run.variant == variant.name && run.replica == 0) {
                report.points.push_back(point_of(variant, run));
            }
        }
    }
    return report;
}

json report_json(const StabilityReport& report) {
    json thresholds = json::array();
    for (const auto& t : report.thresholds) {
        json entry{{"code", t.code},   {"method", t.method}, {"parameter", t.parameter},
                   {"works", t.works}, {"fails", t.fails},   {"measured", t.measured()}};
        if (t.theory) {
            entry["theory"] = *t.theory;
            entry["theory_source"] = t.theory_source;
            entry["tolerance"] = t.tolerance;
            entry["agrees"] = holds_theory(t);
        }
        thresholds.push_back(std::move(entry));
    }
    json points = json::array();
    for (const auto& p : report.points) {
        points.push_back({{"code", p.code},
                          {"at", p.at},
                          {"in", p.in},
                          {"state", p.state},
                          {"detail", p.detail}});
    }
    return {{"case", report.case_name},
            {"thresholds", std::move(thresholds)},
            {"points", std::move(points)}};
}

void print_report(const StabilityReport& report) {
    fmt::print("{}\n", report.case_name);
    TextTable thresholds({"code", "method", "parameter", "works", "fails", "theory", ""});
    for (const auto& t : report.thresholds) {
        thresholds.add({t.code, t.method, t.parameter, fmt::format("{:.5g}", t.works),
                        fmt::format("{:.5g}", t.fails),
                        t.theory ? fmt::format("{:.5g}", *t.theory) : "-",
                        !t.theory         ? ""
                        : holds_theory(t) ? "agrees"
                                          : "disagrees"});
    }
    if (!thresholds.empty()) fmt::print("{}", thresholds.text());
    TextTable points({"code", "at", "state", "detail"});
    for (const auto& p : report.points) {
        std::vector<std::string> at;
        for (const auto& [key, value] : p.in)
            at.push_back(value);
        for (const auto& [key, value] : p.at)
            at.push_back(fmt::format("{}={:g}", key, value));
        points.add({p.code, fmt::format("{}", fmt::join(at, " ")), p.state, p.detail});
    }
    if (!points.empty()) fmt::print("{}", points.text());
}

/// The case whose sweep maps where this one fails: itself unless it names another.
std::string map_of(const catalog::Case& the_case) {
    return the_case.failure_map.empty() ? the_case.file : the_case.failure_map;
}

/// States over the parameters of a case, in all codes that run it; kept in the store, so that a map
/// that was stopped goes on where it was.
void add_map(const Settings& settings, const std::stop_token& stop,
             std::vector<StabilityReport>& reports) {
    store::Store store(settings.results);
    const auto session = run_session(settings, store, stop, true);
    for (const auto& item : session.cases)
        reports.push_back(states_of(item));
}

}  // namespace

int map_stability(const Settings& settings, const std::stop_token& stop) {
    std::vector<StabilityReport> reports;
    int code = exit_ok;
    Settings whole = settings;
    whole.map_axes.clear();
    for (const auto& the_case : selected_cases(whole)) {
        Settings one = settings;
        if (the_case->model != "grains") {
            one.cases = {map_of(*the_case)};
            add_map(one, stop, reports);
            continue;
        }
        reports.push_back(stability_dem(*the_case, settings, stop));
        for (const auto& threshold : reports.back().thresholds) {
            if (!holds_theory(threshold)) code = exit_verdict;
        }
        if (settings.map_axes.empty()) continue;
        one.cases = {map_of(*the_case)};
        add_map(one, stop, reports);
    }
    if (settings.json) {
        json all = json::array();
        for (const auto& report : reports)
            all.push_back(report_json(report));
        fmt::print("{}\n", json{{"stability", std::move(all)}}.dump(2));
    } else {
        for (const auto& report : reports)
            print_report(report);
    }
    return stop.stop_requested() ? exit_interrupted : code;
}

}  // namespace crossgrain::app
