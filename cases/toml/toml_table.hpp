// Reads TOML tables in layers (a case, its quick suite, its variants) and never lets anything slip:
// an unknown key, a wrong type or a value out of range becomes a CaseError with file, line, column,
// key, what was found, what was expected, and the nearest valid key.
#pragma once

#include "cases/toml/text_rules.hpp"
#include "native/base/enum_words.hpp"
#include "native/base/errors.hpp"
#include "native/base/range.hpp"

#include <toml++/toml.h>

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace crossgrain::toml_input {

using crossgrain::Range;

class TomlTable {
  public:
    /// The upper layers come first; a key is taken from the first layer that has it.
    TomlTable(std::string file, std::string path, std::vector<const toml::table*> layers);

    [[nodiscard]] bool has(std::string_view key) const;
    [[nodiscard]] double number(std::string_view key, const Range& range) const;
    [[nodiscard]] std::optional<double> optional_number(std::string_view key,
                                                        const Range& range) const;
    /// One number, or an array of at least one.
    [[nodiscard]] std::vector<double> numbers(std::string_view key, const Range& range) const;
    /// From `least` to `most`, both included.
    [[nodiscard]] std::int64_t
    integer(std::string_view key, std::int64_t least,
            std::int64_t most = std::numeric_limits<std::int64_t>::max()) const;
    // Texts pass the gate of text_rules.hpp: what is no name and no prose is one line.
    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] std::string name(std::string_view key) const;
    [[nodiscard]] std::string prose(std::string_view key) const;
    [[nodiscard]] std::optional<std::string> optional_text(std::string_view key) const;
    [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
    [[nodiscard]] bool boolean(std::string_view key) const;
    [[nodiscard]] bool is_text(std::string_view key) const;
    [[nodiscard]] bool is_table(std::string_view key) const;
    /// One of `words`; returns its index.
    [[nodiscard]] std::size_t choice(std::string_view key,
                                     std::span<const std::string> words) const;
    template <HasWords E>
    [[nodiscard]] E choice(std::string_view key) const {
        return static_cast<E>(choice(key, all_words<E>()));
    }
    /// All layers' sub-tables of that key; an absent one reads as empty.
    [[nodiscard]] TomlTable table(std::string_view key) const;
    /// The tables of an array of tables, from the first layer that has it; empty if none has.
    [[nodiscard]] std::vector<TomlTable> tables(std::string_view key) const;
    /// Of all layers. Such keys are names: throws CaseError for one that cannot be.
    [[nodiscard]] std::vector<std::string> keys() const;

    /// To be called after all keys were asked for. Throws for a key nobody asked for.
    void reject_unknown_keys() const;

    /// For a key that is missing: says so, or points at the unknown key that was probably meant.
    [[nodiscard]] CaseError missing(std::string_view key, std::string expected) const;
    [[nodiscard]] CaseError error(std::string_view key, std::string problem, std::string got,
                                  std::string expected, std::string hint = {}) const;
    [[nodiscard]] const std::string& file() const noexcept { return file_; }
    /// Where the lowest layer begins; 0 without layers.
    [[nodiscard]] int line() const;
    [[nodiscard]] std::string dotted(std::string_view key) const;

  private:
    [[nodiscard]] const toml::node* find(std::string_view key) const;
    [[nodiscard]] const toml::node& required(std::string_view key, std::string_view type) const;
    [[nodiscard]] double checked(std::string_view key, const toml::node& node,
                                 const Range& range) const;
    [[nodiscard]] std::string checked(std::string_view key, const toml::node& node,
                                      TextKind kind) const;
    [[nodiscard]] CaseError error_at(const toml::source_region& where, std::string_view key,
                                     std::string problem, std::string got, std::string expected,
                                     std::string hint) const;

    std::string file_;
    std::string path_;
    std::vector<const toml::table*> layers_;
    mutable std::vector<std::string> asked_;  ///< the known keys, for hints and unknown keys
};

/// The candidate nearest to `word` by edit distance, if any is near enough to be a typing error.
[[nodiscard]] std::optional<std::string> nearest(std::string_view word,
                                                 std::span<const std::string> candidates);

/// Parses a file. Throws CaseError when it cannot be read (text_file.hpp), is nested too deeply
/// (nesting.hpp) or is not TOML.
[[nodiscard]] toml::table parse_toml_file(const std::string& file, std::stop_token stop = {});

/// The same for text that has been read; `file` is for error lines.
[[nodiscard]] toml::table parse_toml(std::string_view text, const std::string& file);

}  // namespace crossgrain::toml_input
