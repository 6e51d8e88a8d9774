// Protects the declarations of keys from saying more than the reader does: every key that is
// declared, and so stands in the JSON schema, is asked for. (That the reader asks for no other key
// is the business of KeyedTable.) A date, which no key takes, is put in the place of each of them:
// the reader must complain of it as it does of a key that it knows.
#include "cases/catalog/case.hpp"
#include "cases/catalog/case_keys.hpp"
#include "native/base/errors.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

using namespace crossgrain;
using namespace crossgrain::toml_input;
namespace fs = std::filesystem;

namespace {

const std::string catalogue = CROSSGRAIN_SOURCE_DIR "/cases/catalog";

/// A table on the way to a key.
struct Step {
    std::string key;
    const TableKeys* keys;
    bool is_list = false;
    std::string kind = {};  ///< word of the table's kind; empty: as it is
};

struct Place {
    std::vector<Step> way;
    std::string key;

    [[nodiscard]] std::string text() const {
        std::string all;
        for (const Step& step : way)
            all += step.key + (step.kind.empty() ? "" : "(" + step.kind + ")") + ".";
        return all + key;
    }
    /// As error lines name it: [quick] and [chart] lie over the case.
    [[nodiscard]] std::string dotted() const {
        std::string all;
        for (const Step& step : way)
            if (step.key != "quick" && step.key != "chart") all += step.key + ".";
        return all + key;
    }
};

bool is_of_scene(const Place& place) {
    return !place.way.empty() && place.way.front().key == "scene";
}

/// All keys below `way`. Tables of layers are those of the case: only their own keys are taken.
void collect(const catalog::Model& model, const TableKeys& keys, const std::vector<Step>& way,
             std::vector<Place>& places) {
    const auto enter = [&](const std::string& key, const TableKeys& inner, bool is_list) {
        auto longer = way;
        longer.push_back({key, &inner, is_list});
        collect(model, inner, longer, places);
    };
    const bool in_layer = !way.empty() && (way[0].key == "quick" || way[0].key == "chart");
    for (const Key& key : keys.keys) {
        places.push_back({way, key.name});
        for (const Rule& rule : key.rules) {
            if (const auto* one = std::get_if<TableRule>(&rule); one && !in_layer)
                enter(key.name, one->keys(), false);
            if (const auto* one = std::get_if<TablesRule>(&rule);
                one && (!in_layer || key.name == "error"))
                enter(key.name, one->keys(), true);
            if (std::holds_alternative<SceneRule>(rule) && way.empty())
                enter(key.name, model.scene(), false);
        }
    }
    if (keys.others) places.push_back({way, "native-dem"});
    if (!keys.kinds) return;
    for (const auto& [word, of_kind] : keys.kinds->of) {
        auto longer = way;
        longer.back().kind = word;
        for (const Key& key : of_kind().keys)
            places.push_back({longer, key.name});
    }
}

/// Which keys a table is made with: some are asked for only beside others.
enum class Made { with_what_is_required, with_all };

/// Something that the rule accepts.
void insert_sample(toml::table& table, const Key& key);

toml::table sample_of(const TableKeys& keys, const std::string& kind, Made made) {
    toml::table table;
    const auto insert_all = [&](const std::vector<Key>& all) {
        for (const Key& key : all)
            if (key.need == Need::required || made == Made::with_all) insert_sample(table, key);
    };
    insert_all(keys.keys);
    if (!keys.kinds || kind.empty()) return table;
    table.insert_or_assign(keys.kinds->key, kind);
    for (const auto& [word, of_kind] : keys.kinds->of)
        if (word == kind) insert_all(of_kind().keys);
    return table;
}

void insert_sample(toml::table& table, const Key& key) {
    const Rule& rule = key.rules.front();
    if (const auto* one = std::get_if<NumberRule>(&rule)) {
        table.insert(key.name, one->range.low == 0 ? std::min(one->range.high, 1.0) : 0.5);
    } else if (std::holds_alternative<NumbersRule>(rule)) {
        table.insert(key.name, toml::array{0.5});
    } else if (const auto* count = std::get_if<IntegerRule>(&rule)) {
        table.insert(key.name, count->least);
    } else if (const auto* choice = std::get_if<ChoiceRule>(&rule)) {
        table.insert(key.name, choice->words.front());
    } else if (const auto* inner = std::get_if<TableRule>(&rule)) {
        table.insert(key.name, sample_of(inner->keys(), "", Made::with_what_is_required));
    } else {
        table.insert(key.name, "text");
    }
}

/// The table at the end of the way, made where there is none; `entry` of every list on it.
toml::table* table_at(toml::table& root, const std::vector<Step>& way, std::size_t entry,
                      Made made) {
    toml::table* table = &root;
    for (const Step& step : way) {
        if (step.is_list) {
            toml::array* list = table->get_as<toml::array>(step.key);
            if (list == nullptr || list->size() <= entry) return nullptr;
            table = (*list)[entry].as_table();
            continue;
        }
        auto* there = table->get_as<toml::table>(step.key);
        const bool fits =
            there != nullptr &&
            (step.kind.empty() || there->get(step.keys->kinds->key)->value_or("") == step.kind);
        if (!fits) {
            table->insert_or_assign(step.key, sample_of(*step.keys, step.kind, made));
            there = table->get_as<toml::table>(step.key);
        }
        table = there;
    }
    return table;
}

/// Variants and sweeps would lay other values over the key.
void lay_nothing_over(const Place& place, toml::table& root) {
    if (auto* variants = root.get_as<toml::array>("variant")) {
        for (auto& variant : *variants) {
            toml::table* table = variant.as_table();
            for (const Step& step : place.way)
                table = table == nullptr ? nullptr : table->get_as<toml::table>(step.key);
            if (table != nullptr) table->erase(place.key);
        }
    }
    // These name what is swept.
    for (const char* about : {"check", "quick", "chart"})
        root.erase(about);
    const std::string in_scene = place.dotted().substr(std::string("scene.").size());
    if (auto* sweep = root.get_as<toml::table>("sweep")) sweep->erase(in_scene);
}

/// Whether the reader complains of the key, as one that it knows, where a date stands in its place.
bool is_asked(const Place& place, toml::table root, std::size_t entry, Made made,
              const fs::path& copy) {
    toml::table* table = table_at(root, place.way, entry, made);
    if (table == nullptr) return false;
    table->insert_or_assign(place.key, toml::date{2000, 1, 1});
    if (is_of_scene(place)) lay_nothing_over(place, root);
    std::ofstream(copy) << root;
    try {
        (void)catalog::load_case(copy.string(), catalog::Suite::full, catalogue + "/readings");
    } catch (const CaseError& error) {
        return error.details().key == place.dotted() &&
               error.details().problem != "is not a known key";
    }
    return false;
}

/// The same for any entry of the lists on its way.
bool is_asked(const Place& place, const fs::path& case_file, const fs::path& copy) {
    const toml::table root = toml::parse_file(case_file.string());
    const bool has_list =
        std::ranges::any_of(place.way, [](const Step& step) { return step.is_list; });
    const std::size_t entries = has_list ? 40 : 1;
    for (std::size_t entry = 0; entry < entries; ++entry) {
        for (const Made made : {Made::with_what_is_required, Made::with_all})
            if (is_asked(place, root, entry, made, copy)) return true;
    }
    return false;
}

/// The cases of a model, or all.
std::vector<fs::path> cases_of(const std::optional<std::string>& model) {
    std::vector<fs::path> files;
    for (const auto& name : catalog::case_names(catalogue)) {
        const fs::path file = fs::path(catalogue) / (name + ".toml");
        const auto own = toml::parse_file(file.string())["model"].value_or(std::string("grains"));
        if (!model || own == *model) files.push_back(file);
    }
    return files;
}

/// The declared keys that no case shows to be asked for; those of a scene are its model's.
std::set<std::string> never_asked(const catalog::Model& model, const TableKeys& keys) {
    const tests::TemporaryDirectory directory;
    std::vector<Place> places;
    collect(model, keys, {}, places);
    BOOST_TEST(places.size() > 100u);
    const auto own = cases_of(model.name), all = cases_of(std::nullopt);
    std::set<std::string> left;
    for (const Place& place : places) {
        const bool asked =
            std::ranges::any_of(is_of_scene(place) ? own : all, [&](const fs::path& file) {
                return is_asked(place, file, directory.path() / "case.toml");
            });
        if (!asked) left.insert(place.text());
    }
    return left;
}

std::string listed(const std::set<std::string>& names) {
    std::string all;
    for (const auto& name : names)
        all += name + " ";
    return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_declared_key_is_read) {
    for (const auto& model : catalog::models()) {
        BOOST_TEST_CONTEXT(model.name) {
            BOOST_TEST(listed(never_asked(model, catalog::case_keys())) == "");
        }
    }
}

BOOST_AUTO_TEST_CASE(a_key_that_is_declared_and_not_read_is_found) {
    TableKeys more = catalog::case_keys();
    more.keys.emplace_back("colour", TextRule{}, "of nothing");
    BOOST_TEST(listed(never_asked(catalog::models().back(), more)) == "colour ");
}
