// A phenomenon that several models and codes show, as a table: rows are what can be compared
// between them, columns are models, codes and the literature (cases/catalog/phenomena/*.toml).
#pragma once

#include "native/base/enum_words.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace crossgrain::studies {

/// How a row is judged against its reference.
enum class RowJudge {
    same,  ///< equivalent within the margin (reference/compare/equivalence.hpp)
    sign,  ///< both significantly on the same side of zero
    word   ///< the same label of a finding
};
constexpr auto words(RowJudge /*of*/) {
    return std::array{"same", "sign", "word"};
}

/// One model, code or source.
struct TableColumn {
    std::string name, title;
    std::string group;               ///< rows name values by column or by group, e.g. "grains"
    std::string code;                ///< empty: the literature
    std::string case_name, variant;  ///< unless a row says otherwise
};

/// What a row takes from a column (or from all of its group).
struct CellSource {
    /// A measurement "alpha", a quotient "overlap_velocity / mean_speed", "finding:wave",
    /// "word:none", or "published:<file>/<name>".
    std::string value;
    std::optional<std::string> case_name, variant;  ///< absent: the column's
};

struct TableRow {
    std::string quantity;
    RowJudge judge = RowJudge::same;
    double margin = 0;                        ///< of `same`, > 0
    bool relative = false;                    ///< the margin is a share of the reference
    std::string reason;                       ///< why this margin; of other rows, what is judged
    std::string against;                      ///< name of the column all others are judged against
    std::string left_out;                     ///< what explains a difference
    std::map<std::string, CellSource> cells;  ///< by name of a column or group
};

/// Pictures shown side by side.
struct TablePicture {
    std::string title, case_name, code, variant, name;
};

/// A curve of a figure: two columns of a stored series, or a measurement over the variants of a
/// sweep.
struct TableCurve {
    std::string title, case_name, code;
    std::string variant, series, x, y;    ///< columns x and y of a series
    std::map<std::string, double> where;  ///< rows of it that count: column and value
    std::string observable, along;        ///< a measurement against a key of the sweep
};

/// Curves of several models in one pair of axes, with the axes' titles.
struct TableFigure {
    std::string title, x, y;
    std::vector<TableCurve> curves;
};

struct Phenomenon {
    std::string name, title, text;
    std::vector<TableColumn> columns;
    std::vector<TableRow> rows;
    std::vector<TablePicture> pictures;
    std::vector<TableFigure> figures;

    /// What a row takes from a column; null if it says nothing about it.
    [[nodiscard]] static const CellSource* source(const TableRow& row, const TableColumn& column);
    /// The cases of all columns and rows, each once.
    [[nodiscard]] std::vector<std::string> cases() const;
};

/// Throws CaseError for a file that is not as expected: unknown keys, columns or groups, a
/// reference that is no column.
[[nodiscard]] Phenomenon load_phenomenon(const std::filesystem::path& file);

/// Names of the phenomena in a directory, sorted; none if there is no such directory.
[[nodiscard]] std::vector<std::string> phenomenon_names(const std::filesystem::path& directory);

}  // namespace crossgrain::studies
