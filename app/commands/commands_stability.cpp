// crossgrain stability: where methods stop working. For distinct elements thresholds by bisection;
// for the lattice models the states their runs were found in, over the sweep of a case or of the
// failure map it names.
#include "app/commands/commands.hpp"
#include "app/output.hpp"
#include "app/pages.hpp"
#include "app/session.hpp"
#include "app/stability/stability.hpp"
#include "app/stability/stability_dem.hpp"
#include "app/text_table.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <set>

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
    if (run.status == "planned") {
        point.state = "not finished";
        point.detail = "not run yet";
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

bool is_on(const TheoryLine& line, const StabilityPoint& point) {
    const auto shares = [](const auto& wanted, const auto& given) {
        return std::ranges::all_of(wanted, [&](const auto& entry) {
            const auto found = given.find(entry.first);
            return found != given.end() && found->second == entry.second;
        });
    };
    return shares(line.in, point.in) && shares(line.at, point.at);
}

/// The quiet region is a class of its own: where theory finds a step stable, what gains energy is
/// inaccurate like what loses it, and "energy gain" is left to steps that are unstable but have not
/// left all bounds yet.
void name_quiet_region(StabilityReport& report) {
    for (StabilityPoint& point : report.points) {
        if (point.state != "energy gain") continue;
        for (const TheoryLine& line : report.theory) {
            const auto value = point.at.find(line.parameter);
            if (value == point.at.end() || value->second >= line.limit || !is_on(line, point))
                continue;
            point.state = "inaccurate";
            point.detail += ", though stable";
        }
    }
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
    json theory = json::array();
    for (const auto& line : report.theory) {
        theory.push_back({{"at", line.at},
                          {"in", line.in},
                          {"parameter", line.parameter},
                          {"limit", line.limit},
                          {"source", line.source}});
    }
    return {{"case", report.case_name},
            {"thresholds", std::move(thresholds)},
            {"theory", std::move(theory)},
            {"points", std::move(points)}};
}

void print_report(const StabilityReport& report) {
    print_results("{}\n", report.case_name);
    TextTable thresholds({"code", "method", "parameter", "works", "fails", "theory", ""});
    for (const auto& t : report.thresholds) {
        thresholds.add({t.code, t.method, t.parameter, fmt::format("{:.5g}", t.works),
                        fmt::format("{:.5g}", t.fails),
                        t.theory ? fmt::format("{:.5g}", *t.theory) : "-",
                        !t.theory         ? ""
                        : holds_theory(t) ? "agrees"
                                          : "disagrees"});
    }
    if (!thresholds.empty()) print_result_text(thresholds.text());
    TextTable points({"code", "at", "state", "detail"});
    for (const auto& p : report.points) {
        std::vector<std::string> at;
        for (const auto& [key, value] : p.in)
            at.push_back(value);
        for (const auto& [key, value] : p.at)
            at.push_back(fmt::format("{}={:g}", key, value));
        points.add({p.code, fmt::format("{}", fmt::join(at, " ")), p.state, p.detail});
    }
    if (!points.empty()) print_result_text(points.text());
    TextTable theory({"theory", "parameter", "stable up to"});
    for (const auto& line : report.theory) {
        std::vector<std::string> at;
        for (const auto& [key, value] : line.in)
            at.push_back(value);
        for (const auto& [key, value] : line.at)
            at.push_back(fmt::format("{}={:g}", key, value));
        theory.add({fmt::format("{}", fmt::join(at, " ")), line.parameter,
                    fmt::format("{:.5g}", line.limit)});
    }
    if (!theory.empty()) print_result_text(theory.text());
}

/// The case whose sweep maps where this one fails: itself unless it names another, which may name
/// another for other keys. The first that has the most of the keys asked for.
std::string map_of(const catalog::Case& the_case, const std::vector<std::string>& axes) {
    const std::string directory = (share_directory() / "catalog").string();
    std::string best = the_case.failure_map.empty() ? the_case.file : the_case.failure_map;
    if (axes.empty()) return best;
    std::ptrdiff_t most = -1;
    std::set<std::string> seen;
    for (std::string name = best; !name.empty() && seen.insert(name).second;) {
        const auto map = catalog::find_case(directory, name, catalog::Suite::full);
        const auto found = std::ranges::count_if(
            axes, [&](const auto& key) { return map.variants.front().parameter(key).has_value(); });
        if (found > most) best = name;
        most = std::max(most, found);
        name = map.failure_map;
    }
    return best;
}

/// States over the parameters of a case, in all codes that run it; kept in the store, so that a map
/// that was stopped goes on where it was.
void add_map(const Settings& settings, store::Store& store, const std::stop_token& stop,
             std::vector<StabilityReport>& reports) {
    const auto session = run_session(settings, store, stop, true);
    for (const auto& item : session.cases) {
        reports.push_back(states_of(item));
        if (item.the_case->model != "grains") continue;
        reports.back().theory = theory_lines(*item.the_case, settings.seed);
        name_quiet_region(reports.back());
    }
}

/// The page of all maps of this call.
void write_maps(const json& maps, const Settings& settings) {
    const Machine machine = this_machine();
    write_page(Page::stability,
               {{"version", program_version()},
                {"created", store::utc_now()},
                {"command", settings.command},
                {"machine", {{"cpu", machine.cpu}, {"cores", machine.cores}}},
                {"stability", maps}},
               settings);
}

/// The cases of this call. Before anything is computed one that was named and cannot be tried out
/// is refused; of all cases it is left out.
std::vector<std::shared_ptr<const catalog::Case>> suited_cases(const Settings& settings,
                                                               const std::stop_token& stop) {
    Settings whole = settings;
    whole.map_axes.clear();
    auto cases = selected_cases(whole, stop);
    if (!settings.map_axes.empty()) return cases;
    std::erase_if(cases, [&](const auto& the_case) {
        if (the_case->model != "grains" || has_residuals(*the_case, settings.seed)) return false;
        if (settings.cases.empty()) return true;
        throw CaseError({.file = the_case->file,
                         .problem = "has no largest stable time step to look for",
                         .got = "a scene without a bottom plate or without a period along x",
                         .expected = "a bed or a lattice"});
    });
    return cases;
}

}  // namespace

int map_stability(const Settings& settings, const std::stop_token& stop) {
    const auto cases = suited_cases(settings, stop);
    store::Store store = open_store(settings, store::Access::write_later);
    std::vector<StabilityReport> reports;
    int code = exit_ok;
    for (const auto& the_case : cases) {
        Settings one = settings;
        one.cases = {map_of(*the_case, settings.map_axes)};
        const bool grains = the_case->model == "grains";
        if (grains) {
            reports.push_back(stability_dem(*the_case, settings, store, stop));
            for (const auto& threshold : reports.back().thresholds) {
                if (!holds_theory(threshold)) code = exit_verdict;
            }
        }
        if (!grains || !settings.map_axes.empty()) add_map(one, store, stop, reports);
    }
    json all = json::array();
    for (const auto& report : reports)
        all.push_back(report_json(report));
    const auto failure = failure_of([&] { write_maps(all, settings); });
    if (settings.json) {
        print_document({{"stability", std::move(all)}});
    } else {
        for (const auto& report : reports)
            print_report(report);
        if (!failure) print_results("written: {}\n", page_file(Page::stability, settings).string());
    }
    if (failure) std::rethrow_exception(failure);
    return stop.stop_requested() ? exit_interrupted : code;
}

}  // namespace crossgrain::app
