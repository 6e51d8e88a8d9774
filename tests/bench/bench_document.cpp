#include "native/base/machine.hpp"
#include "reports/documents/text_table.hpp"
#include "tests/bench/bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace crossgrain::bench {

using nlohmann::json;

json bench_json(const Bench& bench, const BenchReport& report) {
    const Machine machine = this_machine();
    json rows = json::array();
    for (const auto& row : report.rows) {
        rows.push_back({{"name", row.name},
                        {"size", row.size},
                        {"rate", row.rate},
                        {"unit", row.unit},
                        {"ratios", row.ratios},
                        {"details", row.details}});
    }
    json targets = json::array();
    for (const auto& target : report.targets) {
        json entry{{"what", target.what}, {"measured", target.measured}, {"met", target.met()}};
        if (target.at_least != 0) entry["at_least"] = target.at_least;
        if (target.at_most != 0) entry["at_most"] = target.at_most;
        targets.push_back(std::move(entry));
    }
    return {{"bench", bench.name},
            {"machine", {{"cpu", machine.cpu}, {"cores", machine.cores}, {"os", machine.os}}},
            {"rows", std::move(rows)},
            {"targets", std::move(targets)},
            {"notes", report.notes}};
}

namespace {

std::string rows_table(const BenchReport& report) {
    reports::TextTable table({"name", "size", "rate", "unit", "ratios", "details"});
    for (const auto& row : report.rows) {
        std::vector<std::string> ratios, details;
        for (const auto& [other, ratio] : row.ratios)
            ratios.push_back(fmt::format("{:.2f} x {}", ratio, other));
        for (const auto& [key, value] : row.details)
            details.push_back(fmt::format("{} {}", key, value));
        table.add({row.name, std::to_string(row.size), fmt::format("{:.3g}", row.rate), row.unit,
                   fmt::format("{}", fmt::join(ratios, ", ")),
                   fmt::format("{}", fmt::join(details, ", "))});
    }
    return table.text();
}

std::string targets_table(const BenchReport& report) {
    reports::TextTable table({"target", "measured", "required", ""});
    for (const auto& target : report.targets) {
        std::string required;
        if (target.at_least != 0) required = fmt::format(">= {:.3g}", target.at_least);
        if (target.at_most != 0) required += fmt::format(" <= {:.3g}", target.at_most);
        table.add({target.what, fmt::format("{:.3g}", target.measured), required,
                   target.met() ? "met" : "missed"});
    }
    return table.empty() ? "" : table.text();
}

}  // namespace

std::string bench_text(const Bench& bench, const BenchReport& report) {
    std::string text =
        fmt::format("bench {}\n{}\n{}", bench.name, rows_table(report), targets_table(report));
    for (const auto& note : report.notes)
        text += fmt::format("  {}\n", note);
    return text;
}

}  // namespace crossgrain::bench
