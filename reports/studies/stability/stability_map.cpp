#include "reports/studies/stability/stability_map.hpp"

#include "native/base/errors.hpp"
#include "native/base/share_directory.hpp"
#include "reports/session/session.hpp"
#include "reports/studies/stability/stability_dem.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace crossgrain::studies {
namespace {

/// The state a run was found in, or why there is none.
StabilityPoint point_of(const catalog::Variant& variant, const store::RunRecord& run) {
    StabilityPoint point{
        .code = run.code, .state = store::document_word(run.status), .detail = run.reason};
    // A trajectory that left all bounds is what a map looks for.
    if (run.status == store::RunStatus::run_failed) point.state = "blow-up";
    if (run.status == store::RunStatus::timed_out) point.state = "not finished";
    if (run.status == store::RunStatus::planned) {
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

StabilityReport states_of(const judge::CaseReport& item) {
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

}  // namespace

std::vector<std::shared_ptr<const catalog::Case>>
cases_with_thresholds(const run::Settings& settings, const std::stop_token& stop) {
    run::Settings whole = settings;
    whole.map_axes.clear();
    auto cases = session::selected_cases(whole, stop);
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

std::vector<StabilityReport> stability_maps(const run::Settings& settings, store::Store& store,
                                            const std::stop_token& stop) {
    std::vector<StabilityReport> maps;
    const auto session = session::run_session(settings, store, stop, true);
    for (const auto& item : session.cases) {
        maps.push_back(states_of(item));
        if (item.the_case->model != "grains") continue;
        maps.back().theory = theory_lines(*item.the_case, settings.seed);
        name_quiet_region(maps.back());
    }
    return maps;
}

}  // namespace crossgrain::studies
