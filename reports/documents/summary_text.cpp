// The summary over all cases as JSON and as tables.
#include "reports/documents/summary.hpp"

#include "reports/documents/tables.hpp"
#include "reports/documents/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace crossgrain::reports {
namespace {

using nlohmann::json;

std::string bias_table(const std::vector<BiasRow>& rows) {
    TextTable table({"observable", "code", "comparisons", "bias", "95 %", "relative deviation",
                     "of references"});
    for (const auto& row : rows) {
        const auto& s = row.statistics;
        table.add({row.observable, row.code, std::to_string(row.comparisons),
                   fmt::format("{:.4f}", row.bias),
                   s ? fmt::format("{:.4f} ... {:.4f}", s->bias_low, s->bias_high) : "-",
                   s ? fmt::format("{:.4f}", s->relative_deviation) : "-",
                   s ? fmt::format("{:.4f}", s->reference_relative_error) : "-"});
    }
    return table.empty() ? "" : table.text(0) + "\n";
}

std::string cell(const PairRow& row) {
    std::string text;
    const auto add = [&](std::size_t count, const char* word) {
        if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, word);
    };
    add(row.agree, "agree");
    add(row.disagree, "disagree");
    add(row.undecided, "undecided");
    add(row.absent, "absent");
    return text;
}

std::string matrix(const std::vector<PairRow>& rows, compare::Kind kind, const char* title) {
    std::vector<std::string> codes;
    const auto note = [&](const std::string& code) {
        if (std::ranges::find(codes, code) == codes.end()) codes.push_back(code);
    };
    for (const auto& row : rows) {
        if (row.kind != kind) continue;
        note(row.a);
        note(row.b);
    }
    std::vector<std::string> header{title};
    header.insert(header.end(), codes.begin(), codes.end());
    TextTable table(header);
    for (const auto& a : codes) {
        std::vector<std::string> line{a};
        for (const auto& b : codes) {
            const auto found = std::ranges::find_if(rows, [&](const auto& row) {
                return row.kind == kind &&
                       ((row.a == a && row.b == b) || (row.a == b && row.b == a));
            });
            line.push_back(a == b ? "." : (found == rows.end() ? "-" : cell(*found)));
        }
        table.add(std::move(line));
    }
    return codes.empty() ? "" : table.text(0) + "\n";
}

std::string needs_list(const session::SessionReport& report) {
    std::string text;
    for (const auto& item : report.cases) {
        for (const auto& v : item.evaluation.verdicts) {
            if (!v.more_replicas) continue;
            text += fmt::format("undecided: {} {}: needs {} more replicas\n", item.the_case->name,
                                question_text(v), *v.more_replicas);
        }
    }
    return text;
}

}  // namespace

json summary_document(const session::SessionReport& report) {
    json bias = json::array();
    for (const auto& row : bias_rows(report)) {
        json entry{{"observable", row.observable},
                   {"code", row.code},
                   {"comparisons", row.comparisons},
                   {"bias", row.bias},
                   {"ci95", nullptr},
                   {"relative_deviation", nullptr},
                   {"reference_relative_error", nullptr}};
        if (const auto& s = row.statistics) {
            entry["ci95"] = {s->bias_low, s->bias_high};
            entry["relative_deviation"] = s->relative_deviation;
            entry["reference_relative_error"] = s->reference_relative_error;
        }
        bias.push_back(std::move(entry));
    }
    json pairs = json::array();
    for (const auto& row : pair_rows(report)) {
        pairs.push_back({{"a", row.a},
                         {"b", row.b},
                         {"kind", compare::to_string(row.kind)},
                         {"agree", row.agree},
                         {"disagree", row.disagree},
                         {"undecided", row.undecided},
                         {"absent", row.absent}});
    }
    const auto counts = correction_counts(report);
    return {{"correction",
             {{"method", "Holm, 5 % of one false claim or more among all of a kind"},
              {"verdicts", counts.members},
              {"agree", counts.agree},
              {"agree_corrected", counts.agree_corrected},
              {"disagree", counts.disagree},
              {"disagree_corrected", counts.disagree_corrected}}},
            {"bias", std::move(bias)},
            {"pairs", std::move(pairs)}};
}

std::string summary_tables(const session::SessionReport& report) {
    const auto rows = pair_rows(report);
    const auto counts = correction_counts(report);
    std::string text = bias_table(bias_rows(report)) +
                       matrix(rows, compare::Kind::parity, "trajectories") +
                       matrix(rows, compare::Kind::agree, "statistics");
    if (counts.members > 0) {
        text += fmt::format("corrected for {} verdicts that rest on statistics (Holm): {} of {} "
                            "agree, {} of {} disagree\n",
                            counts.members, counts.agree_corrected, counts.agree,
                            counts.disagree_corrected, counts.disagree);
    }
    return text + needs_list(report);
}

}  // namespace crossgrain::reports
