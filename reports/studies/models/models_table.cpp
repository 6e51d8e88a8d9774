#include "reports/studies/models/models_table.hpp"

#include "native/base/share_directory.hpp"

#include "reference/compare/sign.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace crossgrain::studies {
namespace {

using compare::Outcome;
using Kind = TableCell::Kind;

/// The word of a finding that a run, or the runs together, cannot tell.
constexpr std::string_view unsure = "undecided";

TableCell absent(std::string reason) {
    TableCell cell;
    cell.reason = std::move(reason);
    return cell;
}

/// The runs are there, and their estimators gave no such result.
TableCell not_measured(std::string reason) {
    TableCell cell = absent(std::move(reason));
    cell.measured_nothing = true;
    return cell;
}

TableCell number_cell(const compare::Operand& number) {
    return {.kind = Kind::number,
            .value = number.value,
            .standard_error = number.standard_error,
            .degrees_of_freedom = number.degrees_of_freedom};
}

compare::Operand operand_of(const TableCell& cell) {
    return {.value = cell.value,
            .standard_error = cell.standard_error,
            .degrees_of_freedom = cell.degrees_of_freedom};
}

std::string after(const std::string& text, std::string_view prefix) {
    return text.starts_with(prefix) ? text.substr(prefix.size()) : "";
}

TableCell from_literature(const std::string& id, const published::PublishedValues& literature) {
    const auto found = literature.find(id);
    if (!found) return absent(fmt::format("no published value '{}'", id));
    TableCell cell = number_cell({.value = found->value, .standard_error = found->error});
    if (!found->trend.empty()) {
        cell.kind = Kind::word;
        cell.word = found->trend;
    }
    return cell;
}

/// Looks up what one code measured in one variant of one case.
class Reader {
  public:
    Reader(const judge::CaseReport& report, std::string code, std::string variant)
        : report_(report), code_(std::move(code)), variant_(std::move(variant)) {}

    [[nodiscard]] TableCell read(const std::string& value) const {
        const auto& variants = report_.the_case->variants;
        const auto found = std::ranges::find(variants, variant_, &catalog::Variant::name);
        if (found == variants.end()) return absent("no such variant in this suite");
        const auto index = static_cast<std::size_t>(found - variants.begin());
        if (const auto gone = report_.runs.absence(code_, index)) return absent(gone->reason);
        if (report_.runs.replicas(code_, index, 0) == 0) return absent("the code takes no part");
        if (const auto name = after(value, "finding:"); !name.empty()) return finding(name, index);
        const auto slash = value.find(" / ");
        if (slash == std::string::npos) return number(value, index);
        return quotient(number(value.substr(0, slash), index),
                        number(value.substr(slash + 3), index));
    }

  private:
    /// The word of two thirds of the runs or more.
    [[nodiscard]] TableCell finding(const std::string& name, std::size_t variant) const {
        std::map<std::string, std::size_t> words;
        std::size_t runs = 0;
        for (std::int64_t r = 0; r < report_.runs.replicas(code_, variant, 0); ++r) {
            const auto* run = report_.runs.find(code_, variant, 0, r);
            if (run == nullptr) continue;
            for (const auto& one : run->results.findings) {
                if (one.name != name) continue;
                ++words[one.label];
                ++runs;
                break;
            }
        }
        if (runs == 0) return not_measured(fmt::format("'{}' was not found", name));
        std::string told;
        TableCell cell{.kind = Kind::word, .word = std::string(unsure)};
        for (const auto& [word, count] : words) {
            told +=
                fmt::format("{}{} in {} of {} runs", told.empty() ? "" : ", ", word, count, runs);
            if (3 * count >= 2 * runs) cell.word = word;
        }
        if (words.size() > 1) cell.reason = told;
        return cell;
    }

    /// In the variant, or over all variants of the case.
    [[nodiscard]] TableCell number(const std::string& name, std::size_t variant) const {
        const auto found = judge::measured(report_.runs, report_.evaluation, code_, variant, name);
        if (!found) return not_measured(fmt::format("'{}' was not measured", name));
        return number_cell(judge::operand_of(*found));
    }

    [[nodiscard]] static TableCell quotient(const TableCell& above, const TableCell& below) {
        if (above.kind == Kind::absent) return above;
        if (below.kind == Kind::absent) return below;
        if (below.value == 0) return absent("the denominator is 0");
        return number_cell(compare::quotient_of(operand_of(above), operand_of(below)));
    }

    const judge::CaseReport& report_;
    std::string code_, variant_;
};

TableCell read_cell(const TableRow& row, const TableColumn& column,
                    const std::vector<judge::CaseReport>& cases,
                    const published::PublishedValues& literature) {
    const CellSource* source = Phenomenon::source(row, column);
    if (source == nullptr) return absent("");
    const std::string case_name = source->case_name.value_or(column.case_name);
    const std::string variant = source->variant.value_or(column.variant);
    TableCell cell;
    if (const auto id = after(source->value, "published:"); !id.empty()) {
        cell = from_literature(id, literature);
    } else if (const auto word = after(source->value, "word:"); !word.empty()) {
        cell = {.kind = Kind::word, .word = word};
    } else {
        const auto found = std::ranges::find_if(
            cases, [&](const judge::CaseReport& one) { return one.the_case->name == case_name; });
        cell = found == cases.end() ? absent(fmt::format("no case '{}' here", case_name))
                                    : Reader(*found, column.code, variant).read(source->value);
        cell.case_name = case_name;
        cell.variant = variant;
    }
    cell.source = source->value;
    return cell;
}

void judge_same(const TableRow& row, const TableCell& reference, TableCell& cell) {
    const double margin = row.relative ? row.margin * std::abs(reference.value) : row.margin;
    const auto answer =
        compare::equivalence(compare::question_of(operand_of(cell), operand_of(reference), margin));
    cell.outcome = answer.outcome;
    cell.reason = answer.reason;
}

void judge_word(const TableCell& reference, TableCell& cell) {
    const bool told = cell.word != unsure && reference.word != unsure;
    cell.outcome = !told                         ? Outcome::undecided
                   : cell.word == reference.word ? Outcome::agree
                                                 : Outcome::disagree;
    if (cell.outcome == Outcome::agree) return;
    cell.reason = fmt::format("{}, not {}{}{}", cell.word, reference.word,
                              cell.reason.empty() ? "" : ": ", cell.reason);
}

void judge(const TableRow& row, const TableCell& reference, TableCell& cell) {
    if (cell.kind != reference.kind) {
        cell.outcome = Outcome::undecided;
        cell.reason = "a number and a word cannot be compared";
    } else if (cell.kind == Kind::word) {
        judge_word(reference, cell);
    } else if (row.judge == RowJudge::sign) {
        const auto answer = compare::judge_sign(operand_of(cell), operand_of(reference));
        cell.outcome = answer.outcome;
        cell.reason = answer.reason;
    } else {
        judge_same(row, reference, cell);
    }
}

Outcome together(const std::vector<TableCell>& cells) {
    const auto any = [&](Outcome outcome) {
        return std::ranges::any_of(cells,
                                   [&](const TableCell& cell) { return cell.outcome == outcome; });
    };
    for (const Outcome outcome : {Outcome::disagree, Outcome::undecided, Outcome::agree}) {
        if (any(outcome)) return outcome;
    }
    return Outcome::no_reference;
}

}  // namespace

ModelsTable fill(const Phenomenon& phenomenon, const std::vector<judge::CaseReport>& cases,
                 const published::PublishedValues& literature) {
    ModelsTable table{
        .phenomenon = phenomenon, .rows = {}, .figures = fill_figures(phenomenon, cases)};
    for (const TableRow& row : table.phenomenon.rows) {
        FilledRow filled{.row = row, .cells = {}};
        std::size_t reference = 0;
        for (const TableColumn& column : table.phenomenon.columns) {
            if (column.name == row.against) reference = filled.cells.size();
            filled.cells.push_back(read_cell(row, column, cases, literature));
        }
        const TableCell against = filled.cells[reference];
        for (std::size_t c = 0; c < filled.cells.size(); ++c) {
            if (c == reference || filled.cells[c].kind == Kind::absent) continue;
            if (against.kind != Kind::absent) judge(row, against, filled.cells[c]);
        }
        filled.outcome = together(filled.cells);
        table.rows.push_back(std::move(filled));
    }
    return table;
}

std::filesystem::path phenomena_directory() {
    return share_directory() / "catalog" / "phenomena";
}

ModelsTable models_table(const std::string& name, const run::Settings& settings,
                         store::Store& store) {
    const Phenomenon phenomenon = load_phenomenon(phenomena_directory() / (name + ".toml"));
    const auto known = catalog::case_names((share_directory() / "catalog").string());
    run::Settings all = settings;
    all.cases.clear();
    for (const auto& needed : phenomenon.cases()) {
        if (std::ranges::find(known, needed) != known.end()) all.cases.push_back(needed);
    }
    all.codes.clear();
    const auto report = session::run_session(all, store, {}, false);
    return fill(phenomenon, report.cases,
                published::PublishedValues(share_directory() / "published"));
}

nlohmann::json phenomena_document(const std::vector<judge::CaseReport>& cases) {
    const published::PublishedValues literature(share_directory() / "published");
    nlohmann::json all = nlohmann::json::array();
    for (const auto& name : phenomenon_names(phenomena_directory())) {
        const auto phenomenon = load_phenomenon(phenomena_directory() / (name + ".toml"));
        all.push_back(json_of(fill(phenomenon, cases, literature)));
    }
    return all;
}

}  // namespace crossgrain::studies
