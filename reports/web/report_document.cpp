#include "reports/web/report_document.hpp"

#include "reference/judge/case_report.hpp"

#include "adapters/registry/program_version.hpp"
#include "adapters/run/store/results_json.hpp"
#include "native/base/machine.hpp"
#include "reports/documents/documents.hpp"
#include "reports/studies/attribution.hpp"
#include "reports/studies/models/models_table.hpp"

#include <nlohmann/json.hpp>

namespace crossgrain::reports {
namespace {

using nlohmann::json;

/// Figures that a case's runs are meant to fill, whether they ran or not.
json figures_json(const catalog::Case& the_case) {
    json figures = json::array();
    for (const auto& request : the_case.observables) {
        if (request.name == "lid-height") figures.push_back("lid-height");
        if (request.name == "displacement-spectrum") figures.push_back("spectrum");
    }
    for (const auto& check : the_case.checks) {
        if (check.aspect != catalog::Aspect::order) continue;
        figures.push_back("convergence");
        break;
    }
    return figures;
}

/// Curves of the first replica of each code; per-collision tables stay in the store.
json series_json(const judge::CaseReport& item) {
    json all = json::array();
    for (const auto& run : item.runs.records()) {
        if (run.status != store::RunStatus::ok || run.replica != 0) continue;
        for (const auto& series : run.results.series) {
            if (series.name == "collisions") continue;
            json entry{{"code", run.code},       {"variant", run.variant},
                       {"replica", run.replica}, {"rung", run.rung},
                       {"name", series.name},    {"columns", series.columns},
                       {"values", series.values}};
            if (!series.units.empty()) entry["units"] = series.units;
            all.push_back(std::move(entry));
        }
    }
    for (const auto& curve : item.evaluation.curves) {
        all.push_back({{"code", curve.code},
                       {"variant", curve.variant},
                       {"replica", 0},
                       {"name", "convergence"},
                       {"columns", {"dt", "mean_error", "rms_error"}},
                       {"units", {"t", "1", "1"}},
                       {"values", {curve.dt, curve.mean_error, curve.rms_error}}});
    }
    return all;
}

/// Pictures of the first replica of each code, with their pixels.
json pictures_json(const judge::CaseReport& item) {
    json all = json::array();
    for (const auto& run : item.runs.records()) {
        if (run.status != store::RunStatus::ok || run.replica != 0) continue;
        for (const auto& picture : run.results.pictures) {
            json entry = store::picture_to_json(picture);
            entry["code"] = run.code;
            entry["variant"] = run.variant;
            entry["rung"] = run.rung;
            all.push_back(std::move(entry));
        }
    }
    return all;
}

json findings_json(const judge::CaseReport& item) {
    json all = json::array();
    for (const auto& run : item.runs.records()) {
        if (run.status != store::RunStatus::ok) continue;
        for (const auto& finding : run.results.findings) {
            all.push_back({{"code", run.code},
                           {"variant", run.variant},
                           {"replica", run.replica},
                           {"rung", run.rung},
                           {"name", finding.name},
                           {"label", finding.label},
                           {"detail", finding.detail}});
        }
    }
    return all;
}

/// What a variant's name says beyond the sweep: of "P/density=2/rough" in a sweep over two keys,
/// "rough", the name of the written variant.
std::string written_part(const catalog::Variant& variant) {
    std::string rest = variant.name;
    for (std::size_t key = 0; key < variant.parameters.size(); ++key) {
        const auto slash = rest.find('/');
        if (slash == std::string::npos) return {};
        rest.erase(0, slash + 1);
    }
    return rest;
}

/// The keys of the sweep in their order, and each variant's values. Written variants of a swept
/// case are one more key, "variant".
void add_sweep(const catalog::Case& the_case, json& entry) {
    json keys = json::array();
    for (const auto& [key, value] : the_case.variants.front().parameters)
        keys.push_back(key);
    const bool swept = !keys.empty();
    json variants = json::array();
    for (const auto& variant : the_case.variants) {
        json parameters = json::object();
        for (const auto& [key, value] : variant.parameters)
            parameters[key] = value;
        if (const auto rest = written_part(variant); swept && !rest.empty()) {
            if (keys.back() != "variant") keys.push_back("variant");
            parameters["variant"] = rest;
        }
        variants.push_back({{"name", variant.name}, {"parameters", std::move(parameters)}});
    }
    entry["sweep"] = std::move(keys);
    entry["variants"] = std::move(variants);
}

}  // namespace

json report_document(const session::SessionReport& report,
                     const std::vector<studies::HistorySeries>& history,
                     const std::string& command) {
    json cases = json::array();
    for (const auto& item : report.cases) {
        json entry = case_document(item);
        entry["title"] = item.the_case->title;
        entry["text"] = item.the_case->text;
        entry["source"] = item.the_case->source;
        entry["figures"] = figures_json(*item.the_case);
        entry["model"] = item.the_case->model;
        entry["series"] = series_json(item);
        entry["pictures"] = pictures_json(item);
        entry["findings"] = findings_json(item);
        add_sweep(*item.the_case, entry);
        cases.push_back(std::move(entry));
    }
    const Machine machine = this_machine();
    return {{"version", adapters::program_version()},
            {"created", store::utc_now()},
            {"command", command},
            {"machine", {{"cpu", machine.cpu}, {"cores", machine.cores}, {"os", machine.os}}},
            {"codes", codes_document().at("codes")},
            {"cases", std::move(cases)},
            {"certificate", certificate_document(report)},
            {"phenomena", studies::phenomena_document(report.cases)},
            {"attribution", studies::attribution_document(report)},
            {"history", studies::history_document(history)}};
}

}  // namespace crossgrain::reports
