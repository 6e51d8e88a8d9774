// Models against molecular dynamics: a phenomenon's table filled from what stored runs and the
// literature say. Nothing is computed here beyond quotients and verdicts.
#pragma once

#include "reports/session/session.hpp"
#include "reports/studies/models/phenomenon.hpp"
#include "reports/studies/models/phenomenon_figure.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace crossgrain::studies {

struct TableCell {
    enum class Kind { absent, number, word };
    Kind kind = Kind::absent;
    double value = 0, standard_error = 0, degrees_of_freedom = 0;
    std::string word;
    std::string case_name, variant, source;  ///< where it comes from
    bool measured_nothing = false;  ///< absent though the code ran: a wave that is not there
    std::string reason;             ///< why it is absent, or why its verdict is none of agreement
    /// Against the row's reference; nothing for absent cells and the reference itself.
    std::optional<compare::Outcome> outcome;
};

struct FilledRow {
    TableRow row;
    std::vector<TableCell> cells;  ///< shape (columns)
    /// `disagree` if any cell does, else `undecided` if any is, else `agree`; `no_reference` if
    /// there is nothing to compare.
    compare::Outcome outcome = compare::Outcome::no_reference;
};

struct ModelsTable {
    Phenomenon phenomenon;
    std::vector<FilledRow> rows;
    std::vector<FilledFigure> figures;
};

[[nodiscard]] ModelsTable fill(const Phenomenon& phenomenon,
                               const std::vector<judge::CaseReport>& cases,
                               const published::PublishedValues& literature);

/// The directory of the phenomena that come with the program.
[[nodiscard]] std::filesystem::path phenomena_directory();

/// A phenomenon by its name, filled from what the store holds of its cases; those the catalogue
/// does not have are absent. Throws CaseError.
[[nodiscard]] ModelsTable models_table(const std::string& name, const run::Settings& settings,
                                       store::Store& store);

/// All phenomena, filled from the cases of a report.
[[nodiscard]] nlohmann::json phenomena_document(const std::vector<judge::CaseReport>& cases);

[[nodiscard]] std::string text_of(const ModelsTable& table);
[[nodiscard]] nlohmann::json json_of(const ModelsTable& table);

}  // namespace crossgrain::studies
