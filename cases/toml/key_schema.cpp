#include "cases/toml/key_schema.hpp"

#include "cases/toml/text_rules.hpp"

#include <cmath>

namespace crossgrain::toml_input {
namespace {

using nlohmann::json;

json schema_of(const Range& range) {
    json schema{{"type", "number"}};
    if (std::isfinite(range.low)) {
        schema[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
    }
    if (std::isfinite(range.high)) {
        schema[range.high_open ? "exclusiveMaximum" : "maximum"] = range.high;
    }
    return schema;
}

json any_of(std::vector<json> forms) {
    return forms.size() == 1 ? std::move(forms.front()) : json{{"anyOf", std::move(forms)}};
}

// Forms that are one value; what a sweep may list are these.

json scalar(const NumberRule& rule) {
    return schema_of(rule.range);
}
json scalar(const NumbersRule& rule) {
    return schema_of(rule.range);
}
json scalar(const IntegerRule& rule) {
    json schema{{"type", "integer"}, {"minimum", rule.least}};
    if (rule.most < std::numeric_limits<std::int64_t>::max()) schema["maximum"] = rule.most;
    return schema;
}
json scalar(const TextRule& rule) {
    // The limit counts bytes, the schema characters: it never refuses what may be.
    json schema{{"type", "string"}, {"maxLength", longest_text(rule.kind)}};
    if (rule.kind == TextKind::name || !rule.may_be_empty) schema["minLength"] = 1;
    return schema;
}
json scalar(const ChoiceRule& rule) {
    return {{"type", "string"}, {"enum", rule.words}};
}
json scalar(const auto& /*table, list or switch*/) {
    return nullptr;
}

json one_or_more(const NumbersRule& rule) {
    json list{{"type", "array"}, {"items", scalar(rule)}, {"minItems", 1}};
    if (rule.most < std::numeric_limits<std::size_t>::max()) list["maxItems"] = rule.most;
    return any_of({scalar(rule), std::move(list)});
}

/// Not two of the keys of a group, and one of them where that is asked for.
void add_groups(const std::vector<OneOf>& groups, bool is_layer, json& schema) {
    json all = json::array();
    for (const OneOf& group : groups) {
        json given = json::array();
        for (const auto& key : group.keys)
            given.push_back({{"required", {key}}});
        if (group.always && !is_layer) {
            all.push_back({{"oneOf", std::move(given)}});
            continue;
        }
        for (std::size_t i = 0; i < group.keys.size(); ++i) {
            for (std::size_t j = i + 1; j < group.keys.size(); ++j)
                all.push_back({{"not", {{"required", {group.keys[i], group.keys[j]}}}}});
        }
    }
    if (!all.empty()) schema["allOf"] = std::move(all);
}

/// Adds a form of a key that other kinds of the table have too.
void add_form(json& properties, const std::string& key, json form) {
    if (!properties.contains(key) || properties[key] == form) {
        properties[key] = std::move(form);
    } else if (properties[key].contains("anyOf")) {
        properties[key]["anyOf"].push_back(std::move(form));
    } else {
        properties[key] = {{"anyOf", {properties[key], std::move(form)}}};
    }
}

}  // namespace

std::string KeySchema::name_of(KeysOf keys, bool is_layer) const {
    return context_.model + "." + keys().name + (is_layer ? ".layer" : "");
}

json KeySchema::reference(KeysOf keys, bool is_layer) {
    const std::string name = name_of(keys, is_layer);
    if (!definitions_.contains(name)) {
        definitions_[name] = true;  // a table may hold itself
        json schema = table(keys(), is_layer);
        definitions_[name] = std::move(schema);
    }
    return {{"$ref", "#/$defs/" + name}};
}

json KeySchema::sweep_reference() {
    const std::string name = context_.model + ".sweep";
    if (!definitions_.contains(name)) definitions_[name] = swept(context_.scene(), "");
    return {{"$ref", "#/$defs/" + name}};
}

json KeySchema::form(const Rule& rule, bool in_layer) {
    if (const auto* one = std::get_if<NumbersRule>(&rule)) return one_or_more(*one);
    if (std::holds_alternative<BooleanRule>(rule)) return {{"type", "boolean"}};
    if (const auto* one = std::get_if<TextsRule>(&rule)) {
        const auto known = context_.names.find(one->names);
        const auto& words = known == context_.names.end() ? one->words : known->second;
        json item{{"type", "string"}};
        if (!words.empty()) item["enum"] = words;
        return {{"type", "array"}, {"items", std::move(item)}};
    }
    if (const auto* one = std::get_if<TableRule>(&rule)) {
        return reference(one->keys, in_layer || one->is_layer);
    }
    if (const auto* one = std::get_if<TablesRule>(&rule)) {
        return {{"type", "array"}, {"items", reference(one->keys, false)}};
    }
    if (std::holds_alternative<SceneRule>(rule)) return reference(context_.scene, true);
    if (std::holds_alternative<SweepRule>(rule)) return sweep_reference();
    return std::visit([](const auto& one) { return scalar(one); }, rule);
}

json KeySchema::key(const Key& key, bool in_layer) {
    std::vector<json> forms;
    for (const Rule& rule : key.rules)
        forms.push_back(form(rule, in_layer));
    json schema = any_of(std::move(forms));
    schema["description"] = key.text;
    return schema;
}

json KeySchema::table(const TableKeys& keys, bool is_layer) {
    json properties = json::object(), required = json::array();
    for (const Key& one : keys.keys) {
        properties[one.name] = key(one, is_layer);
        if (one.need == Need::required && !is_layer) required.push_back(one.name);
    }
    json schema{{"type", "object"}, {"additionalProperties", false}};
    add_groups(keys.groups, is_layer, schema);
    if (keys.others) {
        schema["additionalProperties"] = key(*keys.others, is_layer);
        if (const auto known = context_.names.find(keys.others->name);
            known != context_.names.end()) {
            json names = known->second;
            for (const Key& one : keys.keys)
                names.push_back(one.name);
            schema["propertyNames"] = {{"enum", std::move(names)}};
        }
    }
    if (keys.kinds) {
        // Which keys there may be, and, where the kind is given, which of them it has.
        for (const auto& [word, of_kind] : keys.kinds->of) {
            json allowed{{keys.kinds->key, true}}, needed = json::array();
            for (const Key& one : of_kind().keys) {
                add_form(properties, one.name, key(one, is_layer));
                allowed[one.name] = key(one, is_layer);
                if (one.need == Need::required && !is_layer) needed.push_back(one.name);
            }
            schema["allOf"].push_back({{"if",
                                        {{"properties", {{keys.kinds->key, {{"const", word}}}}},
                                         {"required", {keys.kinds->key}}}},
                                       {"then",
                                        {{"properties", std::move(allowed)},
                                         {"required", std::move(needed)},
                                         {"additionalProperties", false}}}});
        }
    }
    schema["properties"] = std::move(properties);
    if (!required.empty()) schema["required"] = std::move(required);
    return schema;
}

/// A list of values for every key that is one value; keys of tables inside stand in tables, or
/// behind a dot ("contact.restitution").
json KeySchema::swept(const TableKeys& keys, const std::string& path) {
    json properties = json::object();
    std::vector<Key> all = keys.keys;
    if (keys.kinds) {
        for (const auto& [word, of_kind] : keys.kinds->of)
            all.insert(all.end(), of_kind().keys.begin(), of_kind().keys.end());
    }
    for (const Key& one : all) {
        for (const Rule& rule : one.rules) {
            if (const auto* inner = std::get_if<TableRule>(&rule)) {
                json table = swept(inner->keys(), path + one.name + ".");
                for (const auto& [key, list] : table["properties"].items())
                    add_form(properties, one.name + "." + key, list);
                add_form(properties, one.name, std::move(table));
            }
            json value = std::visit([](const auto& form) { return scalar(form); }, rule);
            if (value.is_null()) continue;
            json list{{"type", "array"}, {"items", std::move(value)}, {"minItems", 1}};
            if (!context_.words_of_star(path + one.name).empty()) {
                list = any_of({std::move(list), {{"const", {"*"}}}});
            }
            add_form(properties, one.name, std::move(list));
        }
    }
    return {
        {"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

}  // namespace crossgrain::toml_input
