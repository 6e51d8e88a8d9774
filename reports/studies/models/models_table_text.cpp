// Tables of models against molecular dynamics as text and as JSON.
#include "reports/studies/models/models_table.hpp"

#include "reports/documents/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace crossgrain::studies {
namespace {

using compare::Outcome;
using Kind = TableCell::Kind;

std::string cell_text(const TableCell& cell, bool is_reference) {
    if (cell.kind == Kind::absent) {
        if (cell.source.empty()) return "";
        return cell.measured_nothing ? "-" : "not run";
    }
    std::string text = cell.kind == Kind::word ? cell.word : fmt::format("{:.3g}", cell.value);
    if (cell.kind == Kind::number && cell.standard_error > 0) {
        text += fmt::format(" +- {:.1g}", cell.standard_error);
    }
    if (is_reference) return text + " (ref)";
    if (cell.outcome == Outcome::disagree) return text + " (!)";
    return cell.outcome == Outcome::undecided ? text + " (?)" : text;
}

}  // namespace

std::string text_of(const ModelsTable& table) {
    std::vector<std::string> header{"quantity"};
    for (const TableColumn& column : table.phenomenon.columns)
        header.push_back(column.title);
    header.emplace_back("verdict");
    reports::TextTable text(header);
    std::string notes;
    for (const FilledRow& row : table.rows) {
        std::vector<std::string> line{row.row.quantity};
        for (std::size_t c = 0; c < row.cells.size(); ++c) {
            const bool is_reference = table.phenomenon.columns[c].name == row.row.against;
            line.push_back(cell_text(row.cells[c], is_reference));
        }
        line.push_back(compare::to_string(row.outcome));
        text.add(std::move(line));
        if (row.outcome == Outcome::disagree && !row.row.left_out.empty()) {
            notes += fmt::format("  {}: {}\n", row.row.quantity, row.row.left_out);
        }
    }
    return fmt::format("{}: {}\n{}{}{}", table.phenomenon.name, table.phenomenon.title, text.text(),
                       notes.empty() ? "" : "where they differ:\n", notes);
}

nlohmann::json json_of(const ModelsTable& table) {
    using nlohmann::json;
    json columns = json::array(), rows = json::array(), pictures = json::array();
    for (const TableColumn& column : table.phenomenon.columns) {
        columns.push_back({{"name", column.name},
                           {"title", column.title},
                           {"code", column.code},
                           {"case", column.case_name},
                           {"variant", column.variant}});
    }
    for (const FilledRow& filled : table.rows) {
        json cells = json::array();
        for (std::size_t c = 0; c < filled.cells.size(); ++c) {
            const TableCell& cell = filled.cells[c];
            json entry{
                {"column", table.phenomenon.columns[c].name},
                {"source", cell.source},
                {"case", cell.case_name},
                {"variant", cell.variant},
                {"reason", cell.reason},
                {"measured_nothing", cell.measured_nothing},
                {"verdict", cell.outcome ? json(compare::to_string(*cell.outcome)) : json()}};
            if (cell.kind == Kind::number) {
                entry["value"] = cell.value;
                entry["stderr"] = cell.standard_error;
            }
            if (cell.kind == Kind::word) entry["word"] = cell.word;
            cells.push_back(std::move(entry));
        }
        const TableRow& row = filled.row;
        rows.push_back({{"quantity", row.quantity},
                        {"against", row.against},
                        {"margin", row.judge == RowJudge::same ? json(row.margin) : json()},
                        {"relative", row.relative},
                        {"reason", row.reason},
                        {"left_out", row.left_out},
                        {"verdict", compare::to_string(filled.outcome)},
                        {"cells", std::move(cells)}});
    }
    for (const TablePicture& picture : table.phenomenon.pictures) {
        pictures.push_back({{"title", picture.title},
                            {"case", picture.case_name},
                            {"code", picture.code},
                            {"variant", picture.variant},
                            {"name", picture.name}});
    }
    return {{"phenomenon", table.phenomenon.name},
            {"title", table.phenomenon.title},
            {"text", table.phenomenon.text},
            {"columns", std::move(columns)},
            {"rows", std::move(rows)},
            {"pictures", std::move(pictures)},
            {"figures", json_of(table.figures)}};
}

}  // namespace crossgrain::studies
