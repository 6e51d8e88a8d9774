// What a table of an input file may hold. Every key is declared once, by the reader of its table;
// reading (keyed_table.hpp) and the JSON schema (key_schema.hpp) both go by the declaration.
#pragma once

#include "cases/toml/toml_table.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace crossgrain::toml_input {

struct TableKeys;
/// A declaration is a function: tables hold tables that other files declare.
using KeysOf = const TableKeys& (*)();

struct NumberRule {
    Range range;
};
/// One number, or an array of at least one and at most `most`.
struct NumbersRule {
    Range range;
    std::size_t most = std::numeric_limits<std::size_t>::max();
};
struct IntegerRule {
    std::int64_t least = 0;
    std::int64_t most = std::numeric_limits<std::int64_t>::max();  ///< included
};
struct TextRule {
    TextKind kind = TextKind::line;
    bool may_be_empty = true;  ///< a name never is
};
/// An array of texts: some of `words`, where there are any; names of something, e.g. "code".
struct TextsRule {
    std::vector<std::string> words = {};
    std::string names = {};
};
struct BooleanRule {};
struct ChoiceRule {
    std::vector<std::string> words;
};
/// A table; `is_layer`: it is laid over another one, so that it needs not be complete.
struct TableRule {
    KeysOf keys;
    bool is_layer = false;
};
/// [[key]]: any number of tables.
struct TablesRule {
    KeysOf keys;
};
/// A layer of [scene], whose keys are those of the case's model; [sweep] lists values of them.
struct SceneRule {};
struct SweepRule {};

using Rule = std::variant<NumberRule, NumbersRule, IntegerRule, TextRule, TextsRule, BooleanRule,
                          ChoiceRule, TableRule, TablesRule, SceneRule, SweepRule>;

enum class Need { optional, required };

struct Key {
    Key(std::string key, Rule rule, std::string description, Need needed = Need::optional)
        : Key(std::move(key), std::vector{std::move(rule)}, std::move(description), needed) {}
    /// Any of several forms.
    Key(std::string key, std::vector<Rule> forms, std::string description,
        Need needed = Need::optional)
        : name(std::move(key)), rules(std::move(forms)), text(std::move(description)),
          need(needed) {}

    std::string name;
    std::vector<Rule> rules;
    std::string text;  ///< for people: what it is, in one line
    Need need;         ///< of a table that is complete by itself
};

/// Of these keys one at most is given, and exactly one if `always`; else other keys decide.
struct OneOf {
    std::vector<std::string> keys;
    bool always = true;
};

/// Further keys, by the word that the key `key` has.
struct Kinds {
    std::string key;
    std::vector<std::pair<std::string, KeysOf>> of;
    [[nodiscard]] std::vector<std::string> words() const;
};

struct TableKeys {
    std::string name;  ///< of the declaration, each its own
    std::vector<Key> keys;
    std::vector<OneOf> groups = {};
    std::optional<Kinds> kinds = {};
    /// What any other key is; its name says whose names such keys are, e.g. "code".
    std::optional<Key> others = {};
};

}  // namespace crossgrain::toml_input
