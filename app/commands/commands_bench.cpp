// crossgrain bench: speed side by side, in one run.
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "cases/toml/toml_table.hpp"
#include "native/base/errors.hpp"
#include "native/base/machine.hpp"
#include "reports/documents/text_table.hpp"
#include "reports/session/session.hpp"
#include "tests/bench/bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace crossgrain::app {
namespace {

using nlohmann::json;

const bench::Bench& bench_named(const std::string& name) {
    std::vector<std::string> known;
    for (const auto& bench : bench::benches()) {
        if (bench.name == name) return bench;
        known.push_back(bench.name);
    }
    const auto near = toml_input::nearest(name, known);
    throw CaseError({.problem = "unknown bench",
                     .got = fmt::format("'{}'", name),
                     .expected = fmt::format("one of {}", fmt::join(known, ", ")),
                     .hint = near ? fmt::format("did you mean '{}'?", *near) : ""});
}

json bench_json(const bench::Bench& bench, const bench::BenchReport& report) {
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

std::string rows_table(const bench::BenchReport& report) {
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

std::string targets_table(const bench::BenchReport& report) {
    reports::TextTable table({"target", "measured", "promised", ""});
    for (const auto& target : report.targets) {
        std::string promised;
        if (target.at_least != 0) promised = fmt::format(">= {:.3g}", target.at_least);
        if (target.at_most != 0) promised += fmt::format(" <= {:.3g}", target.at_most);
        table.add({target.what, fmt::format("{:.3g}", target.measured), promised,
                   target.met() ? "met" : "missed"});
    }
    return table.empty() ? "" : table.text();
}

}  // namespace

int run_benches(const Settings& settings, const std::vector<std::string>& names, bool quick,
                std::stop_token stop) {
    std::vector<const bench::Bench*> chosen;
    for (const auto& name : names)
        chosen.push_back(&bench_named(name));
    if (names.empty()) {
        for (const auto& bench : bench::benches())
            chosen.push_back(&bench);
    }
    json documents = json::array();
    for (const bench::Bench* bench : chosen) {
        if (!settings.quiet) print_note("bench {}: {}", bench->name, bench->title);
        const auto progress = [&](const std::string& line) {
            if (!settings.quiet) print_note("  {}", line);
        };
        const bench::BenchReport report =
            bench->run({.quick = quick, .stop = stop, .progress = progress});
        if (settings.json) {
            documents.push_back(bench_json(*bench, report));
            continue;
        }
        print_results("bench {}\n{}\n{}", bench->name, rows_table(report), targets_table(report));
        for (const auto& note : report.notes)
            print_results("  {}\n", note);
    }
    if (settings.json) {
        // One bench is one document, as scripts expect it; several are a list.
        print_document(documents.size() == 1 ? documents.front() : documents);
    }
    return stop.stop_requested() ? exit_interrupted : exit_ok;
}

}  // namespace crossgrain::app
