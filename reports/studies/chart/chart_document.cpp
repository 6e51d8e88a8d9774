#include "reports/studies/chart/chart_document.hpp"

#include "native/base/digest.hpp"
#include "native/base/errors.hpp"
#include "native/base/file_stem.hpp"
#include "reports/documents/csv.hpp"
#include "reports/documents/text_table.hpp"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <set>
#include <tuple>

namespace crossgrain::studies {
namespace {

using nlohmann::json;

json point_json(const ChartPoint& p) {
    json parameters = json::object();
    for (const auto& [key, value] : p.parameters)
        parameters[key] = value;
    return {{"code", p.code},         {"variant", p.variant},
            {"drops", p.drops},       {"parameters", std::move(parameters)},
            {"runs", p.runs},         {"cpu_s", p.cpu_s},
            {"start_s", p.start_s},   {"value", p.value},
            {"bias", p.bias},         {"bias_stderr", p.bias_stderr},
            {"scatter", p.scatter},   {"error", p.error},
            {"accurate", p.accurate}, {"on_front", p.on_front}};
}

struct FailureGroup {
    std::vector<std::string> variants;
};

/// By code, status and reason, in this order.
std::map<std::tuple<std::string, std::string, std::string>, FailureGroup>
grouped(const std::vector<ChartFailure>& failures) {
    std::map<std::tuple<std::string, std::string, std::string>, FailureGroup> groups;
    for (const auto& f : failures)
        groups[{f.code, f.status, f.reason}].variants.push_back(f.variant);
    return groups;
}

std::string first_and_more(const std::vector<std::string>& variants) {
    if (variants.size() == 1) return variants.front();
    return fmt::format("{} and {} more", variants.front(), variants.size() - 1);
}

std::string front_table(const ChartedObservable& o) {
    reports::TextTable table({"code", "rung", "cpu s", "error", "bias", ""});
    for (const auto& p : o.points) {
        if (!p.on_front) continue;
        table.add({p.code, p.variant, fmt::format("{:.3g}", p.cpu_s + p.start_s),
                   fmt::format("{:.2g}", p.error),
                   fmt::format("{:.2g} +- {:.1g}", p.bias, p.bias_stderr),
                   p.accurate ? "accurate" : ""});
    }
    return table.text(4);
}

}  // namespace

json chart_json(const Chart& chart) {
    json observables = json::array();
    for (const auto& o : chart.observables) {
        json points = json::array();
        for (const auto& p : o.points)
            points.push_back(point_json(p));
        observables.push_back(
            {{"observable", o.observable},
             {"against", o.against},
             {"reason", o.reason},
             {"unit", o.unit},
             {"margin", o.margin},
             {"reference", {{"value", o.reference}, {"stderr", o.reference_stderr}}},
             {"problem", o.problem},
             {"points", std::move(points)}});
    }
    json failures = json::array();
    for (const auto& [key, group] : grouped(chart.failures)) {
        const auto& [code, status, reason] = key;
        failures.push_back(
            {{"code", code}, {"status", status}, {"reason", reason}, {"variants", group.variants}});
    }
    return {{"case", chart.case_name},
            {"title", chart.title},
            {"observables", std::move(observables)},
            {"failures", std::move(failures)}};
}

std::string chart_stem(const std::string& case_name) {
    const std::string stem = file_stem({case_name});
    return stem == case_name ? stem : fmt::format("{}-{:.8}", stem, sha256(case_name));
}

void add_earlier_charts(const std::filesystem::path& directory, json& charts) {
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(directory))
        if (entry.path().extension() == ".json") files.insert(entry.path());
    std::set<std::string> present;
    for (const auto& chart : charts)
        present.insert(chart.at("case").get<std::string>());
    for (const auto& file : files) {
        std::ifstream in(file);
        auto chart = json::parse(in, nullptr, false);
        if (!chart.is_object() || !chart.contains("case") || !chart["case"].is_string()) {
            throw CaseError({.file = file.string(),
                             .problem = "is no chart",
                             .hint = "delete it, or chart its case again"});
        }
        if (!present.contains(chart["case"].get<std::string>())) charts.push_back(std::move(chart));
    }
}

std::string chart_csv(const Chart& chart) {
    std::string text =
        "case,observable,against,margin,reference,reference_stderr,code,variant,drops,"
        "runs,cpu_s,start_s,value,bias,bias_stderr,scatter,error,accurate,on_front\n";
    for (const auto& o : chart.observables) {
        for (const auto& p : o.points) {
            text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                                reports::csv_field(chart.case_name),
                                reports::csv_field(o.observable), reports::csv_field(o.against),
                                o.margin, o.reference, o.reference_stderr,
                                reports::csv_field(p.code), reports::csv_field(p.variant),
                                reports::csv_field(p.drops), p.runs, p.cpu_s, p.start_s, p.value,
                                p.bias, p.bias_stderr, p.scatter, p.error, p.accurate, p.on_front);
        }
    }
    return text;
}

std::string chart_table(const Chart& chart) {
    std::string text = fmt::format("{}: {}\n", chart.case_name, chart.title);
    for (const auto& o : chart.observables) {
        text +=
            fmt::format("  {} against {} = {:.6g} +- {:.1g}; accurate within {:g} ({}); {} points, "
                        "the front:\n",
                        o.observable, o.against, o.reference, o.reference_stderr, o.margin,
                        o.reason, o.points.size());
        text += o.problem.empty() ? front_table(o) : fmt::format("    none: {}\n", o.problem);
    }
    if (chart.failures.empty()) return text + "  nothing failed\n";
    text += "  not in the chart:\n";
    for (const auto& [key, group] : grouped(chart.failures)) {
        const auto& [code, status, reason] = key;
        text += fmt::format("    {} {}: {} ({})\n", code, status, reason,
                            first_and_more(group.variants));
    }
    return text;
}

}  // namespace crossgrain::studies
