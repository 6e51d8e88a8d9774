// What can be said over all cases of a report: verdicts corrected for their number, bias and
// scatter of every code in every observable, and codes against codes.
#pragma once

#include "reference/compare/model_bias.hpp"
#include "reports/session/session.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace crossgrain::reports {

/// How many verdicts are members of the families, and how many of their claims stand.
struct CorrectionCounts {
    std::size_t members = 0;
    std::size_t agree = 0, agree_corrected = 0;
    std::size_t disagree = 0, disagree_corrected = 0;
};
[[nodiscard]] CorrectionCounts correction_counts(const session::SessionReport& report);

/// A code against all references of one observable: closed forms and published values that are not
/// 0, where the measured value has their sign.
struct BiasRow {
    std::string observable, code;
    std::size_t comparisons = 0;
    double bias = 1;
    /// Nothing for a single comparison: it has no scatter.
    std::optional<compare::ModelBias> statistics;
};
[[nodiscard]] std::vector<BiasRow> bias_rows(const session::SessionReport& report);

/// Verdicts of one kind between two codes, over all cases.
struct PairRow {
    std::string a, b;
    compare::Kind kind = compare::Kind::parity;
    std::size_t agree = 0, disagree = 0, undecided = 0, absent = 0;
};
[[nodiscard]] std::vector<PairRow> pair_rows(const session::SessionReport& report);

/// {"correction": {...}, "bias": [...], "pairs": [...]}
[[nodiscard]] nlohmann::json summary_document(const session::SessionReport& report);
/// The same for people, with what each undecided verdict needs.
[[nodiscard]] std::string summary_tables(const session::SessionReport& report);

}  // namespace crossgrain::reports
