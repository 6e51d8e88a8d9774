// JSON Schema (draft 2020-12) of what declarations of keys (keys.hpp) accept.
#pragma once

#include "cases/toml/keys.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace crossgrain::toml_input {

/// What declarations leave open.
struct SchemaContext {
    std::string model;  ///< in the names of definitions
    KeysOf scene;       ///< the keys of its [scene]
    /// What names may be, by what declarations call them, e.g. "code"; any where it is not said.
    std::map<std::string, std::vector<std::string>> names;
    /// The words for which ["*"] stands in a sweep over a key; none if it stands for nothing.
    std::vector<std::string> (*words_of_star)(const std::string& key);
};

/// Makes schemas of tables that refer to each other, and holds them by name.
class KeySchema {
  public:
    explicit KeySchema(SchemaContext context) : context_(std::move(context)) {}

    /// {"$ref": ...} to the schema of a table: of one that is complete, or of a layer, in which
    /// keys may be missing because other layers have them.
    [[nodiscard]] nlohmann::json complete(KeysOf keys) { return reference(keys, false); }
    [[nodiscard]] nlohmann::json layer(KeysOf keys) { return reference(keys, true); }
    /// Of the value of one key.
    [[nodiscard]] nlohmann::json key(const Key& key, bool in_layer);

    /// By name, as "$defs" of the document.
    [[nodiscard]] nlohmann::json& definitions() { return definitions_; }
    [[nodiscard]] std::string name_of(KeysOf keys, bool is_layer) const;

  private:
    nlohmann::json reference(KeysOf keys, bool is_layer);
    nlohmann::json sweep_reference();
    nlohmann::json table(const TableKeys& keys, bool is_layer);
    nlohmann::json form(const Rule& rule, bool in_layer);
    nlohmann::json swept(const TableKeys& keys, const std::string& path);

    SchemaContext context_;
    nlohmann::json definitions_ = nlohmann::json::object();
};

}  // namespace crossgrain::toml_input
