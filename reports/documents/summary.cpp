#include "reports/documents/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace crossgrain::reports {
namespace {

using compare::Kind;
using compare::Outcome;
using compare::Verdict;

/// The member of a verdict's measurement: its relative statistical error.
compare::ModelComparison comparison_of(const Verdict& v) {
    const double model = v.reference + v.difference;
    const double statistical = std::sqrt(
        std::max(0.0, v.standard_error * v.standard_error - v.reference_error * v.reference_error));
    return {.model = model,
            .reference = v.reference,
            .reference_relative_error = v.reference_error / std::abs(v.reference),
            .model_relative_error = statistical / std::abs(model)};
}

bool has_ratio(const Verdict& v) {
    const double ratio = (v.reference + v.difference) / v.reference;
    return std::isfinite(ratio) && ratio > 0 && std::isfinite(v.uncertainty);
}

}  // namespace

CorrectionCounts correction_counts(const session::SessionReport& report) {
    CorrectionCounts counts;
    for (const auto& item : report.cases) {
        for (const auto& v : item.evaluation.verdicts) {
            if (!v.corrected) continue;
            ++counts.members;
            counts.agree += v.outcome == Outcome::agree ? 1 : 0;
            counts.disagree += v.outcome == Outcome::disagree ? 1 : 0;
            counts.agree_corrected += v.corrected == Outcome::agree ? 1 : 0;
            counts.disagree_corrected += v.corrected == Outcome::disagree ? 1 : 0;
        }
    }
    return counts;
}

std::vector<BiasRow> bias_rows(const session::SessionReport& report) {
    std::map<std::pair<std::string, std::string>, std::vector<compare::ModelComparison>> groups;
    for (const auto& item : report.cases) {
        for (const auto& v : item.evaluation.verdicts) {
            if (has_ratio(v)) groups[{v.observable, v.code}].push_back(comparison_of(v));
        }
    }
    std::vector<BiasRow> rows;
    for (const auto& [who, comparisons] : groups) {
        BiasRow row{.observable = who.first, .code = who.second, .comparisons = comparisons.size()};
        if (comparisons.size() > 1) {
            row.statistics = compare::model_bias(comparisons);
            row.bias = row.statistics->bias;
        } else {
            row.bias = comparisons.front().model / comparisons.front().reference;
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<PairRow> pair_rows(const session::SessionReport& report) {
    std::map<std::tuple<Kind, std::string, std::string>, PairRow> rows;
    for (const auto& item : report.cases) {
        for (const auto& v : item.evaluation.verdicts) {
            if (!compare::is_pair(v)) continue;
            PairRow& row = rows[{v.kind, v.code, v.against.name}];
            row.a = v.code;
            row.b = v.against.name;
            row.kind = v.kind;
            auto& count = v.outcome == Outcome::agree       ? row.agree
                          : v.outcome == Outcome::disagree  ? row.disagree
                          : v.outcome == Outcome::undecided ? row.undecided
                                                            : row.absent;
            ++count;
        }
    }
    std::vector<PairRow> list;
    for (auto& [key, row] : rows)
        list.push_back(std::move(row));
    return list;
}

}  // namespace crossgrain::reports
