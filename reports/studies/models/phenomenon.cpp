#include "reports/studies/models/phenomenon.hpp"

#include "cases/toml/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace crossgrain::studies {
namespace {

using toml_input::Range;
using toml_input::TomlTable;

TableColumn read_column(const TomlTable& t) {
    TableColumn column{.name = t.name("name"), .title = t.text("title")};
    column.group = t.optional_text("group").value_or("");
    column.code = t.optional_text("code").value_or("");
    if (!column.code.empty()) {
        column.case_name = t.text("case");
        column.variant = t.optional_text("variant").value_or("");
    }
    t.reject_unknown_keys();
    return column;
}

std::map<std::string, CellSource> read_cells(const TomlTable& t,
                                             const std::vector<TableColumn>& columns) {
    std::map<std::string, CellSource> cells;
    const TomlTable values = t.table("value");
    const TomlTable cases = t.table("case"), variants = t.table("variant");
    std::vector<std::string> known;
    for (const TableColumn& column : columns)
        known.insert(known.end(), {column.name, column.group});
    const auto check = [&](const TomlTable& table, const std::string& key) {
        if (std::ranges::find(known, key) != known.end()) return;
        throw table.error(key, "is no column and no group of columns", "",
                          fmt::format("one of {}", fmt::join(known, ", ")));
    };
    for (const auto& key : values.keys()) {
        check(values, key);
        cells[key].value = values.text(key);
    }
    // A column may differ from its group in the case or variant only.
    const auto cell_of = [&](const TomlTable& table, const std::string& key) -> CellSource& {
        if (const auto own = cells.find(key); own != cells.end()) return own->second;
        const auto column = std::ranges::find(columns, key, &TableColumn::name);
        const auto group = column == columns.end() ? cells.end() : cells.find(column->group);
        if (group == cells.end()) {
            throw table.error(key, "has no value in this row", "", "a key of 'value'");
        }
        return cells.emplace(key, group->second).first->second;
    };
    const auto add = [&](const TomlTable& table, auto member) {
        for (const auto& key : table.keys()) {
            check(table, key);
            cell_of(table, key).*member = table.text(key);
        }
    };
    add(cases, &CellSource::case_name);
    add(variants, &CellSource::variant);
    return cells;
}

TableRow read_row(const TomlTable& t, const std::vector<TableColumn>& columns,
                  const std::string& reference) {
    TableRow row{.quantity = t.text("quantity"), .reason = t.text("reason")};
    if (t.has("judge")) row.judge = t.choice<RowJudge>("judge");
    if (row.judge == RowJudge::same) row.margin = t.number("margin", Range::positive());
    if (t.has("relative")) row.relative = t.boolean("relative");
    row.against = t.optional_text("against").value_or(reference);
    row.left_out = t.optional_text("left_out").value_or("");
    const bool known = std::ranges::any_of(
        columns, [&](const TableColumn& column) { return column.name == row.against; });
    if (!known) throw t.error("against", "is no column", row.against, "the name of a column");
    row.cells = read_cells(t, columns);
    t.reject_unknown_keys();
    return row;
}

TablePicture read_picture(const TomlTable& t) {
    TablePicture picture{.title = t.text("title"),
                         .case_name = t.text("case"),
                         .code = t.text("code"),
                         .variant = t.optional_text("variant").value_or(""),
                         .name = t.text("name")};
    t.reject_unknown_keys();
    return picture;
}

TableCurve read_curve(const TomlTable& t) {
    TableCurve curve{.title = t.text("title"), .case_name = t.text("case"), .code = t.text("code")};
    if (t.has("series")) {
        curve.variant = t.optional_text("variant").value_or("");
        curve.series = t.text("series");
        curve.x = t.text("x");
        curve.y = t.text("y");
        const TomlTable where = t.table("where");
        for (const auto& column : where.keys())
            curve.where[column] = where.number(column, Range::any());
    } else {
        curve.observable = t.text("observable");
        curve.along = t.text("along");
    }
    t.reject_unknown_keys();
    return curve;
}

TableFigure read_figure(const TomlTable& t) {
    TableFigure figure{.title = t.text("title"), .x = t.text("x"), .y = t.text("y")};
    for (const TomlTable& curve : t.tables("curve"))
        figure.curves.push_back(read_curve(curve));
    t.reject_unknown_keys();
    return figure;
}

}  // namespace

const CellSource* Phenomenon::source(const TableRow& row, const TableColumn& column) {
    for (const auto& key : {column.name, column.group}) {
        if (const auto found = row.cells.find(key); found != row.cells.end()) {
            return &found->second;
        }
    }
    return nullptr;
}

std::vector<std::string> Phenomenon::cases() const {
    std::vector<std::string> all;
    const auto add = [&](const std::string& one) {
        if (!one.empty() && std::ranges::find(all, one) == all.end()) all.push_back(one);
    };
    for (const TableColumn& column : columns)
        add(column.case_name);
    for (const TableRow& row : rows) {
        for (const auto& [key, cell] : row.cells)
            add(cell.case_name.value_or(""));
    }
    for (const TablePicture& picture : pictures)
        add(picture.case_name);
    for (const TableFigure& figure : figures) {
        for (const TableCurve& curve : figure.curves)
            add(curve.case_name);
    }
    return all;
}

Phenomenon load_phenomenon(const std::filesystem::path& file) {
    const toml::table root = toml_input::parse_toml_file(file.string());
    const TomlTable t(file.string(), "", {&root});
    Phenomenon phenomenon{
        .name = file.stem().string(), .title = t.text("title"), .text = t.prose("text")};
    const std::string reference = t.text("reference");
    for (const TomlTable& column : t.tables("column"))
        phenomenon.columns.push_back(read_column(column));
    for (const TomlTable& row : t.tables("row"))
        phenomenon.rows.push_back(read_row(row, phenomenon.columns, reference));
    for (const TomlTable& picture : t.tables("picture"))
        phenomenon.pictures.push_back(read_picture(picture));
    for (const TomlTable& figure : t.tables("figure"))
        phenomenon.figures.push_back(read_figure(figure));
    t.reject_unknown_keys();
    return phenomenon;
}

std::vector<std::string> phenomenon_names(const std::filesystem::path& directory) {
    std::vector<std::string> names;
    if (!std::filesystem::is_directory(directory)) return names;
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace crossgrain::studies
