#include "reports/documents/text_table.hpp"
#include "reports/studies/stability/stability.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace crossgrain::studies {

using nlohmann::json;

bool holds_theory(const StabilityThreshold& threshold) {
    return !threshold.theory ||
           std::abs(threshold.measured() / *threshold.theory - 1) <= threshold.tolerance;
}

json stability_json(const StabilityReport& report) {
    json thresholds = json::array();
    for (const auto& t : report.thresholds) {
        json entry{{"code", t.code},   {"method", t.method}, {"parameter", t.parameter},
                   {"works", t.works}, {"fails", t.fails},   {"measured", t.measured()}};
        if (t.packing) {
            entry["packing"] = {
                {"limit", t.packing->limit},
                {"eigenvalue", {t.packing->eigenvalue.real(), t.packing->eigenvalue.imag()}},
                {"residual", t.packing->residual}};
        }
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

std::string stability_text(const StabilityReport& report) {
    std::string text = report.case_name + "\n";
    reports::TextTable thresholds(
        {"code", "method", "parameter", "works", "fails", "packing", "residual", "theory"});
    for (const auto& t : report.thresholds) {
        thresholds.add({t.code, t.method, t.parameter, fmt::format("{:.5g}", t.works),
                        fmt::format("{:.5g}", t.fails),
                        t.packing ? fmt::format("{:.5g}", t.packing->limit) : "-",
                        t.packing ? fmt::format("{:.1e}", t.packing->residual) : "-",
                        !t.theory         ? ""
                        : holds_theory(t) ? "agrees"
                                          : "disagrees"});
    }
    if (!thresholds.empty()) text += thresholds.text();
    reports::TextTable points({"code", "at", "state", "detail"});
    for (const auto& p : report.points) {
        std::vector<std::string> at;
        for (const auto& [key, value] : p.in)
            at.push_back(value);
        for (const auto& [key, value] : p.at)
            at.push_back(fmt::format("{}={:g}", key, value));
        points.add({p.code, fmt::format("{}", fmt::join(at, " ")), p.state, p.detail});
    }
    if (!points.empty()) text += points.text();
    reports::TextTable theory({"theory", "parameter", "stable up to"});
    for (const auto& line : report.theory) {
        std::vector<std::string> at;
        for (const auto& [key, value] : line.in)
            at.push_back(value);
        for (const auto& [key, value] : line.at)
            at.push_back(fmt::format("{}={:g}", key, value));
        theory.add({fmt::format("{}", fmt::join(at, " ")), line.parameter,
                    fmt::format("{:.5g}", line.limit)});
    }
    if (!theory.empty()) text += theory.text();
    return text;
}

}  // namespace crossgrain::studies
