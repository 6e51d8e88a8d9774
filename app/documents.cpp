#include "app/documents.hpp"

#include "app/catalogue/catalogue.hpp"
#include "app/evaluate/attribution.hpp"
#include "app/evaluate/compare_summary.hpp"
#include "app/models/models_table.hpp"
#include "reference/compare/parity.hpp"
#include "reference/compare/student.hpp"
#include "reports/store/results_json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace crossgrain::app {
namespace {

using nlohmann::json;

json run_json(const store::RunRecord& run) {
    return {{"code", run.code},
            {"version", run.version},
            {"program", run.program},
            {"digest", run.digest},
            {"variant", run.variant},
            {"replica", run.replica},
            {"seed", run.seed},
            {"status", run.status},
            {"reason", run.reason},
            {"log_tail", run.log_tail},
            {"settings", json::parse(run.settings_json, nullptr, false)},
            {"cpu_s", run.cpu_s},
            {"wall_s", run.wall_s},
            {"work", run.work},
            {"work_unit", run.work_unit},
            {"created", run.created},
            {"cached", run.cached}};
}

json measurement_json(const CodeMeasurement& item) {
    const auto& m = item.combined.measurement;
    const double dof = item.combined.degrees_of_freedom;
    const double half = m.standard_error > 0 && dof >= 1
                            ? compare::student_quantile(0.975, dof) * m.standard_error
                            : 0.0;
    json settings(m.settings);
    settings["dt"] = item.dt;
    settings["replicas"] = item.combined.replicas;
    return {{"code", item.code},
            {"variant", item.variant},
            {"observable", m.observable},
            {"value", m.value},
            {"stderr", m.standard_error},
            {"systematic", m.systematic},
            {"ci95", {m.value - half, m.value + half}},
            {"n", m.n},
            {"unit", m.unit},
            {"settings", std::move(settings)}};
}

/// The fitted order of a convergence curve, as the report page expects it.
json order_json(const ConvergenceCurve& curve) {
    const auto interval = [](double value, double error) {
        return json{value - 1.96 * error, value + 1.96 * error};
    };
    return {{"code", curve.code},
            {"variant", curve.variant},
            {"observable", "convergence-order"},
            {"value", curve.order},
            {"stderr", curve.order_error},
            {"systematic", 0.0},
            {"ci95", interval(curve.order, curve.order_error)},
            {"n", curve.dt.size()},
            {"unit", "1"},
            {"settings", {{"of", curve.observable}}}};
}

/// The reading of a model's rules that a verdict is about, where the case sweeps over readings: the
/// first component of its variant.
std::string reading_of(const catalog::Case& the_case, const compare::Verdict& verdict) {
    const std::string first = verdict.setting.substr(0, verdict.setting.find_first_of("/,"));
    for (const auto& variant : the_case.variants) {
        if (variant.parameters.empty()) continue;
        const auto& [key, value] = variant.parameters.front();
        if (key == "reading" && value == first) return value;
    }
    return {};
}

json verdict_json(const catalog::Case& the_case, const compare::Verdict& v) {
    return {{"code", v.code},
            {"observable", v.observable},
            {"kind", compare::to_string(v.kind)},
            {"against", v.against},
            {"setting", v.setting},
            {"reading", reading_of(the_case, v)},
            {"difference", v.difference},
            {"uncertainty", v.uncertainty},
            {"limit", v.limit},
            {"limit_reason", v.limit_reason},
            {"verdict", compare::to_string(v.outcome)},
            {"expected", v.expected},
            {"corrected", v.corrected ? json(compare::to_string(*v.corrected)) : json()},
            {"more_replicas", v.more_replicas ? json(*v.more_replicas) : json()},
            {"reason", v.reason}};
}

json case_json(const CaseReport& item) {
    json runs = json::array();
    for (const auto& run : item.runs.records())
        runs.push_back(run_json(run));
    json measurements = json::array();
    for (const auto& m : item.evaluation.measurements)
        measurements.push_back(measurement_json(m));
    for (const auto& curve : item.evaluation.curves)
        measurements.push_back(order_json(curve));
    json verdicts = json::array();
    for (const auto& v : item.evaluation.verdicts)
        verdicts.push_back(verdict_json(*item.the_case, v));
    return {{"case", item.the_case->name},
            {"runs", std::move(runs)},
            {"measurements", std::move(measurements)},
            {"verdicts", std::move(verdicts)}};
}

json pair_json(const CertificatePair& pair) {
    json digits = json::object();
    for (const auto& [time, dx] : pair.max_dx) {
        digits[time] = compare::matching_digits(dx, pair.diameter);
    }
    return {{"case", pair.case_name},
            {"a", pair.a},
            {"b", pair.b},
            {"contact_time", pair.contact_time},
            {"max_dx", pair.max_dx},
            {"curve", {{"columns", {"t", "max_dx"}}, {"values", {pair.curve_t, pair.curve_dx}}}},
            {"digits", std::move(digits)},
            {"limits", pair.limits},
            {"max_dh", pair.max_dh},
            {"limits_dh", pair.limits_dh},
            {"verdict", compare::to_string(pair.outcome)},
            {"expected", pair.expected},
            {"reason", pair.reason}};
}

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
json series_json(const CaseReport& item) {
    json all = json::array();
    for (const auto& run : item.runs.records()) {
        if (run.status != "ok" || run.replica != 0) continue;
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
json pictures_json(const CaseReport& item) {
    json all = json::array();
    for (const auto& run : item.runs.records()) {
        if (run.status != "ok" || run.replica != 0) continue;
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

json findings_json(const CaseReport& item) {
    json all = json::array();
    for (const auto& run : item.runs.records()) {
        if (run.status != "ok") continue;
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

json codes_document(std::stop_token stop) {
    json list = json::array();
    for (const auto& code : codes()) {
        const auto available = code->probe(stop);
        list.push_back({{"code", code->name()},
                        {"version", available.version},
                        {"program", available.program},
                        {"digest", available.digest},
                        {"status", available.installed ? "ok" : "not_installed"},
                        {"reason", available.reason},
                        {"expresses", code->features()}});
    }
    return {{"codes", std::move(list)}};
}

json cases_document(const SessionReport& report) {
    json cases = json::array();
    for (const auto& item : report.cases)
        cases.push_back(case_json(item));
    return {{"cases", std::move(cases)}, {"summary", summary_document(report)}};
}

json certificate_document(const SessionReport& report) {
    json pairs = json::array();
    for (const auto& item : report.cases) {
        for (const auto& pair : item.evaluation.certificate)
            pairs.push_back(pair_json(pair));
    }
    return {{"length_unit", "reduced units"}, {"pairs", std::move(pairs)}};
}

json history_document(const std::vector<HistorySeries>& history) {
    json all = json::array();
    for (const auto& series : history) {
        json points = json::array();
        for (const auto& point : series.points) {
            points.push_back({{"entry", point.run_id},
                              {"created", point.created},
                              {"value", point.value},
                              {"stderr", point.standard_error},
                              {"version", point.version}});
        }
        json band = series.drift == Drift::too_few ? json() : json{series.low, series.high};
        all.push_back({{"case", series.case_name},
                       {"variant", series.variant},
                       {"code", series.code},
                       {"observable", series.observable},
                       {"unit", series.unit},
                       {"seed", series.seed},
                       {"settings", json::parse(series.settings_json, nullptr, false)},
                       {"points", std::move(points)},
                       {"band", std::move(band)},
                       {"allowance", series.allowance},
                       {"status", to_string(series.drift)}});
    }
    return {{"series", std::move(all)}};
}

json report_document(const SessionReport& report, const std::vector<HistorySeries>& history,
                     const Settings& settings) {
    json cases = json::array();
    for (const auto& item : report.cases) {
        json entry = case_json(item);
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
    return {{"version", program_version()},
            {"created", store::utc_now()},
            {"command", settings.command},
            {"machine", {{"cpu", machine.cpu}, {"cores", machine.cores}, {"os", machine.os}}},
            {"codes", codes_document().at("codes")},
            {"cases", std::move(cases)},
            {"certificate", certificate_document(report)},
            {"phenomena", phenomena_document(report.cases)},
            {"attribution", attribution_document(report)},
            {"history", history_document(history)}};
}

}  // namespace crossgrain::app
