// Reads a table by the declaration of its keys (keys.hpp): types, ranges and words are looked up
// there. A key that is not declared cannot be read.
#pragma once

#include "cases/toml/keys.hpp"
#include "cases/toml/toml_table.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crossgrain::toml_input {

/// All throw CaseError for what the file has wrong, as TomlTable does, and std::logic_error for a
/// key that is not declared, or not as what is asked for.
class KeyedTable {
  public:
    KeyedTable(TomlTable table, const TableKeys& keys) : table_(std::move(table)), keys_(&keys) {}

    [[nodiscard]] bool has(std::string_view key) const;
    [[nodiscard]] double number(std::string_view key) const;
    [[nodiscard]] std::optional<double> optional_number(std::string_view key) const;
    [[nodiscard]] std::vector<double> numbers(std::string_view key) const;
    [[nodiscard]] std::int64_t integer(std::string_view key) const;
    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] std::optional<std::string> optional_text(std::string_view key) const;
    [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
    [[nodiscard]] bool boolean(std::string_view key) const;
    /// The index of the word.
    [[nodiscard]] std::size_t choice(std::string_view key) const;
    /// Declared with all words of the enum.
    template <HasWords E>
    [[nodiscard]] E choice(std::string_view key) const {
        return static_cast<E>(choice(key));
    }
    /// The key of the group of `key` (OneOf) that is given. Throws CaseError if none or two are.
    [[nodiscard]] std::string exactly_one(std::string_view key) const;

    [[nodiscard]] bool is_text(std::string_view key) const;
    [[nodiscard]] bool is_table(std::string_view key) const;
    [[nodiscard]] KeyedTable table(std::string_view key) const;
    /// For a table that is read elsewhere: throws CaseError when it is none.
    void check_table(std::string_view key) const;
    [[nodiscard]] std::vector<KeyedTable> tables(std::string_view key) const;
    /// The keys that the file has here; all of them are taken as names (TomlTable::keys).
    [[nodiscard]] std::vector<std::string> names() const { return table_.keys(); }

    /// To be called after all keys were asked for. Throws for a key nobody asked for.
    void reject_unknown_keys() const { table_.reject_unknown_keys(); }
    [[nodiscard]] CaseError missing(std::string_view key, std::string expected) const;
    [[nodiscard]] CaseError error(std::string_view key, std::string problem, std::string got,
                                  std::string expected, std::string hint = {}) const;
    [[nodiscard]] const std::string& file() const noexcept { return table_.file(); }
    [[nodiscard]] int line() const { return table_.line(); }

  private:
    [[nodiscard]] const Key& declared(std::string_view key) const;
    [[nodiscard]] const Key* find(std::string_view key) const;
    template <class R>
    [[nodiscard]] const R& rule(std::string_view key) const;

    TomlTable table_;
    const TableKeys* keys_;
};

}  // namespace crossgrain::toml_input
