#include "cases/catalog/case_schema.hpp"

#include "cases/catalog/case_keys.hpp"
#include "cases/scene/choices.hpp"
#include "cases/toml/key_schema.hpp"

namespace crossgrain::catalog {
namespace {

using nlohmann::json;
using toml_input::KeySchema;

/// Holds where a key has this word.
json with_word(const char* key, const std::string& word) {
    return {{"properties", {{key, {{"const", word}}}}}, {"required", {key}}};
}

/// An entry with the options of the observable that it names, and no others.
json observable_schema(KeySchema& schema, const std::vector<ObservableWords>& observables,
                       const json& written) {
    json names = json::array(), by_name = json::array();
    json properties{{"name", written["properties"]["name"]}};
    for (const auto& observable : observables) {
        names.push_back(observable.name);
        json allowed{{"name", true}}, needed = json::array({"name"});
        for (const auto& option : observable.options) {
            allowed[option.name] = schema.key(option, false);
            properties[option.name] = written["additionalProperties"];
            if (option.need == toml_input::Need::required) needed.push_back(option.name);
        }
        by_name.push_back({{"if", with_word("name", observable.name)},
                           {"then",
                            {{"description", observable.text},
                             {"properties", std::move(allowed)},
                             {"required", std::move(needed)},
                             {"additionalProperties", false}}}});
    }
    properties["name"]["enum"] = std::move(names);
    return {{"type", "object"},
            {"properties", std::move(properties)},
            {"required", written["required"]},
            {"additionalProperties", false},
            {"allOf", std::move(by_name)}};
}

/// A scene that no variant and no sweep adds to is complete.
json complete_scene(KeySchema& schema, const Model& model) {
    return {{"if", {{"anyOf", {{{"required", {"variant"}}}, {{"required", {"sweep"}}}}}}},
            {"else",
             {{"properties", {{"scene", schema.complete(model.scene)}}}, {"required", {"scene"}}}}};
}

}  // namespace

json case_schema(const std::vector<std::string>& codes,
                 const std::map<std::string, std::vector<ObservableWords>>& observables) {
    json definitions = json::object(), completions = json::array({true}), by_model;
    for (const Model& model : models()) {
        KeySchema schema({.model = model.name,
                          .scene = model.scene,
                          .names = {{"code", codes}},
                          .words_of_star = scene::words_of});
        const json file = schema.complete(case_keys);
        const json scene = complete_scene(schema, model);
        json& own = schema.definitions();
        own[schema.name_of(case_keys, false)]["allOf"].push_back(scene);
        json& entry = own[schema.name_of(observable_keys, false)];
        entry = observable_schema(schema, observables.at(model.name), entry);
        definitions.update(own);
        completions.push_back(file);
        // The first model is that of files that name none.
        by_model = by_model.is_null() ? file
                                      : json{{"if", with_word("model", model.name)},
                                             {"then", file},
                                             {"else", std::move(by_model)}};
    }
    by_model["$schema"] = "https://json-schema.org/draft/2020-12/schema";
    by_model["title"] = "crossgrain case";
    by_model["$defs"] = std::move(definitions);
    // Always true: editors that complete keys look into "anyOf" and not behind "if".
    by_model["anyOf"] = std::move(completions);
    return by_model;
}

}  // namespace crossgrain::catalog
