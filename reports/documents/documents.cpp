#include "reports/documents/documents.hpp"

#include "reference/judge/case_report.hpp"

#include "adapters/registry/codes.hpp"
#include "reference/compare/parity.hpp"
#include "reference/compare/student.hpp"
#include "reports/documents/summary.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace crossgrain::reports {
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
            {"status", store::document_word(run.status)},
            {"reason", run.reason},
            {"log_tail", run.log_tail},
            {"settings", json::parse(run.settings_json, nullptr, false)},
            {"cpu_s", run.cpu_s},
            {"wall_s", run.wall_s},
            {"work", run.work},
            {"work_unit", run.work_unit},
            {"created", run.created},
            {"cached", run.cached},
            {"measured_again", run.measured_again}};
}

/// A number without an error, or with one that rests on nothing, is its own interval.
json ci95_of(double value, double error, double degrees_of_freedom) {
    const double half = error > 0 && degrees_of_freedom >= 1
                            ? compare::student_quantile(0.975, degrees_of_freedom) * error
                            : 0.0;
    return {value - half, value + half};
}

json measurement_json(const judge::CodeMeasurement& item) {
    const auto& m = item.combined.measurement;
    json settings(m.settings);
    settings["dt"] = item.dt;
    settings["replicas"] = item.combined.replicas;
    return {{"code", item.code},
            {"variant", item.variant},
            {"observable", m.observable},
            {"value", m.value},
            {"stderr", m.standard_error},
            {"systematic", m.systematic},
            {"ci95", ci95_of(m.value, m.standard_error, item.combined.degrees_of_freedom)},
            {"n", m.n},
            {"unit", m.unit},
            {"settings", std::move(settings)}};
}

/// The fitted order of a convergence curve, as the report page expects it.
json order_json(const judge::ConvergenceCurve& curve) {
    return {{"code", curve.code},
            {"variant", curve.variant},
            {"observable", "convergence-order"},
            {"value", curve.order},
            {"stderr", curve.order_error},
            {"systematic", 0.0},
            {"ci95", ci95_of(curve.order, curve.order_error, curve.order_degrees_of_freedom)},
            {"n", curve.dt.size()},
            {"unit", "1"},
            {"settings", {{"of", curve.observable}}}};
}

json verdict_json(const compare::Verdict& v) {
    return {{"code", v.code},
            {"observable", compare::observable_text(v)},
            {"kind", compare::to_string(v.kind)},
            {"against", compare::to_string(v.against)},
            {"setting", compare::setting_text(v)},
            {"reading", v.rule_variant},
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

}  // namespace

json case_document(const judge::CaseReport& item) {
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
        verdicts.push_back(verdict_json(v));
    return {{"case", item.the_case->name},
            {"runs", std::move(runs)},
            {"measurements", std::move(measurements)},
            {"verdicts", std::move(verdicts)}};
}

namespace {

json pair_json(const judge::CertificatePair& pair) {
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

}  // namespace

json codes_document(std::stop_token stop) {
    json list = json::array();
    for (const auto& code : adapters::codes()) {
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

json cases_document(const session::SessionReport& report) {
    json cases = json::array();
    for (const auto& item : report.cases)
        cases.push_back(case_document(item));
    return {{"cases", std::move(cases)}, {"summary", summary_document(report)}};
}

json certificate_document(const session::SessionReport& report) {
    json pairs = json::array();
    for (const auto& item : report.cases) {
        for (const auto& pair : item.evaluation.certificate)
            pairs.push_back(pair_json(pair));
    }
    return {{"length_unit", "reduced units"}, {"pairs", std::move(pairs)}};
}

}  // namespace crossgrain::reports
