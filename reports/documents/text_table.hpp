// Plain text tables with aligned columns.
#pragma once

#include <string>
#include <vector>

namespace crossgrain::reports {

class TextTable {
  public:
    explicit TextTable(std::vector<std::string> header) : rows_{std::move(header)} {}
    /// A row on one line: what cannot be shown is escaped (printable.hpp).
    void add(std::vector<std::string> row);
    [[nodiscard]] bool empty() const noexcept { return rows_.size() < 2; }
    /// Columns as wide as their longest cell in characters, separated by two spaces; indented by
    /// `indent` spaces.
    [[nodiscard]] std::string text(std::size_t indent = 2) const;

  private:
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace crossgrain::reports
