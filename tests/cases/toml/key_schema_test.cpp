// Protects the way from declarations to a JSON schema: types, limits, words, groups and kinds
// arrive; layers need nothing; sweeps list what is one value.
#include "cases/toml/key_schema.hpp"

#include <boost/test/unit_test.hpp>

using namespace crossgrain::toml_input;
using nlohmann::json;

namespace {

const TableKeys& disc_keys() {
    static const TableKeys keys{
        .name = "disc",
        .keys = {{"radius", NumberRule{Range::left_open(0, 2)}, "of a disc", Need::required}}};
    return keys;
}

const TableKeys& keys() {
    static const Kinds kinds{.key = "kind", .of = {{"disc", disc_keys}}};
    static const TableKeys all{
        .name = "test",
        .keys = {{"kind", ChoiceRule{kinds.words()}, "of shape", Need::required},
                 {"ends", NumbersRule{Range::not_negative(), 2}, "first and last"},
                 {"count", IntegerRule{2, 5}, "a count"},
                 {"name", TextRule{TextKind::name}, "a name"},
                 {"codes", TextsRule{.names = "code"}, "some codes"},
                 {"form", {BooleanRule{}, TableRule{disc_keys}}, "a switch or a table"},
                 {"step", NumberRule{Range::any()}, "either"},
                 {"steps", NumberRule{Range::any()}, "or"}},
        .groups = {OneOf{{"step", "steps"}}},
        .kinds = kinds};
    return all;
}

const TableKeys& named_keys() {
    static const TableKeys all{.name = "named",
                               .keys = {{"default", IntegerRule{1}, "of all"}},
                               .others = {{"code", IntegerRule{0}, "of a code"}}};
    return all;
}

const TableKeys& swept_keys() {
    static const TableKeys all{.name = "swept", .keys = {{"sweep", SweepRule{}, "lists"}}};
    return all;
}

KeySchema schema() {
    return KeySchema({.model = "m",
                      .scene = keys,
                      .names = {{"code", {"a", "b"}}},
                      .words_of_star = [](const std::string& key) {
                          return key == "kind" ? std::vector<std::string>{"disc"}
                                               : std::vector<std::string>{};
                      }});
}

json table_of(KeysOf of, bool is_layer = false) {
    KeySchema all = schema();
    const json reference = is_layer ? all.layer(of) : all.complete(of);
    BOOST_TEST(reference == (json{{"$ref", "#/$defs/" + all.name_of(of, is_layer)}}));
    return all.definitions()[all.name_of(of, is_layer)];
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_rule_arrives_in_the_schema) {
    const json table = table_of(keys);
    json p = table["properties"];
    BOOST_TEST(p["count"]["description"] == "a count");
    for (auto& property : p)
        property.erase("description");
    const json end{{"type", "number"}, {"minimum", 0.0}};
    BOOST_TEST(
        p["ends"]["anyOf"] ==
        json::array({end, {{"type", "array"}, {"items", end}, {"minItems", 1}, {"maxItems", 2}}}));
    BOOST_TEST(p["count"] == (json{{"type", "integer"}, {"minimum", 2}, {"maximum", 5}}));
    BOOST_TEST(p["name"] == (json{{"type", "string"}, {"minLength", 1}, {"maxLength", 120}}));
    BOOST_TEST(p["codes"]["items"]["enum"] == json::array({"a", "b"}));
    BOOST_TEST(p["form"]["anyOf"] ==
               json::array({{{"type", "boolean"}}, {{"$ref", "#/$defs/m.disc"}}}));
    BOOST_TEST(p["radius"] ==
               (json{{"type", "number"}, {"exclusiveMinimum", 0.0}, {"maximum", 2.0}}));
    BOOST_TEST(table["additionalProperties"] == false);
}

BOOST_AUTO_TEST_CASE(what_is_needed_is_needed_of_complete_tables_only) {
    const json table = table_of(keys);
    BOOST_TEST(table["required"] == json::array({"kind"}));
    BOOST_TEST(table["allOf"][0]["oneOf"] ==
               json::array({{{"required", {"step"}}}, {{"required", {"steps"}}}}));
    BOOST_TEST(table["allOf"][1]["then"]["required"] == json::array({"radius"}));
    const json layer = table_of(keys, true);
    BOOST_TEST(!layer.contains("required"));
    BOOST_TEST(layer["allOf"][0] == (json{{"not", {{"required", {"step", "steps"}}}}}));
    BOOST_TEST(layer["allOf"][1]["then"]["required"] == json::array());
    BOOST_TEST(layer["properties"]["form"]["anyOf"][1]["$ref"] == "#/$defs/m.disc.layer");
}

BOOST_AUTO_TEST_CASE(names_are_those_that_there_are) {
    const json table = table_of(named_keys);
    BOOST_TEST(table["propertyNames"]["enum"] == json::array({"a", "b", "default"}));
    BOOST_TEST(table["additionalProperties"]["minimum"] == 0);
}

BOOST_AUTO_TEST_CASE(a_sweep_lists_values_of_keys_that_are_one_value) {
    KeySchema all = schema();
    (void)all.complete(swept_keys);
    const json p = all.definitions()["m.sweep"]["properties"];
    BOOST_TEST(p["count"]["items"] == (json{{"type", "integer"}, {"minimum", 2}, {"maximum", 5}}));
    BOOST_TEST(p["ends"]["items"]["type"] == "number");
    BOOST_TEST(p["kind"]["anyOf"][1]["const"] == json::array({"*"}));
    BOOST_TEST(p["form.radius"] == p["form"]["properties"]["radius"]);
    BOOST_TEST(!p.contains("codes"));
}
