#include "cases/catalog/case_keys.hpp"

#include "cases/catalog/case.hpp"
#include "cases/catalog/check_file.hpp"
#include "cases/catalog/fit_file.hpp"
#include "cases/catalog/variant_file.hpp"
#include "cases/scene/model_file.hpp"
#include "cases/scene/scene_file.hpp"

namespace crossgrain::catalog {
namespace {

using toml_input::ChoiceRule;
using toml_input::IntegerRule;
using toml_input::Key;
using toml_input::NumberRule;
using toml_input::Range;
using toml_input::TableKeys;
using toml_input::TableRule;
using toml_input::TablesRule;
using toml_input::TextKind;
using toml_input::TextRule;
using toml_input::TextsRule;
using enum toml_input::Need;

constexpr double longest_run = 1e9;  // s; what is longer overflows the clock

const TableKeys& replicas_keys() {
    static const TableKeys keys{
        .name = "replicas",
        .keys = {{"default", IntegerRule{1, most_runs}, "runs of every code, default 1"}},
        .others = {{"code", IntegerRule{0, most_runs}, "runs of that code; 0: none"}}};
    return keys;
}

const TableKeys& replicas_in_keys() {
    static const TableKeys keys{
        .name = "replicas_in",
        .keys = {},
        .others = {{"variant", IntegerRule{1, most_runs}, "how many times as many runs"}}};
    return keys;
}

const TableKeys& error_keys() {
    static const TableKeys keys{
        .name = "chart.error",
        .keys = {
            {"observable", TextRule{}, "a measurement", required},
            {"against", TextRule{}, R"("analytic:..." or "converged:<variant>")", required},
            {"margin", NumberRule{Range::positive()}, "beyond it a result is inaccurate", required},
            {"reason", TextRule{}, "why this margin", required}}};
    return keys;
}

std::vector<std::string> model_words() {
    std::vector<std::string> words;
    for (const Model& model : models())
        words.push_back(model.name);
    return words;
}

/// What a file may say, and [quick] and [chart] may say anew.
std::vector<Key> layered_keys() {
    return {
        {"name", TextRule{TextKind::name}, "the file's name without .toml", required},
        {"title", TextRule{}, "one line", required},
        {"source", TextRule{}, "author, section, equation", required},
        {"text", TextRule{TextKind::prose}, "one paragraph: what, why, what to expect", required},
        {"suites", TextsRule{{"quick", "full"}}, "where `crossgrain validate` takes it in",
         required},
        {"model", ChoiceRule{model_words()}, "default \"grains\""},
        {"failure_map", TextRule{}, "the case whose sweep maps where this one's model fails"},
        {"time_limit", NumberRule{Range::left_open(0, longest_run)}, "wall seconds per run",
         required},
        {"replicas", TableRule{replicas_keys}, "independent runs per code"},
        {"replicas_in", TableRule{replicas_in_keys}, "more of them, by variant, name or pattern"},
        {"scene", toml_input::SceneRule{}, "what is simulated"},
        {"variant", TablesRule{variant_keys}, "each is laid over [scene]"},
        {"sweep", toml_input::SweepRule{}, "lists of values; every combination is a variant"},
        {"observable", TablesRule{observable_keys}, "what is measured"},
        {"fit", TablesRule{fit_keys}, "a measurement over the variants, one per code"},
        {"check", TablesRule{check_keys}, "a question with its limit"}};
}

TableKeys with(std::string name, std::vector<Key> more) {
    TableKeys keys{.name = std::move(name), .keys = layered_keys()};
    keys.keys.insert(keys.keys.end(), more.begin(), more.end());
    return keys;
}

std::vector<Key> suite_keys() {
    return {{"quick", TableRule{quick_keys, true}, "laid over the case in the quick suite"},
            {"chart", TableRule{chart_keys, true}, "laid over it by `crossgrain chart`"}};
}

}  // namespace

const std::vector<Model>& models() {
    static const std::vector<Model> all{{"grains", scene::scene_keys},
                                        {"lattice-gas", scene::lattice_gas_keys},
                                        {"hopper-automaton", scene::hopper_automaton_keys},
                                        {"synthetic-signal", scene::synthetic_signal_keys}};
    return all;
}

const TableKeys& case_keys() {
    static const TableKeys keys = with("case", suite_keys());
    return keys;
}

const TableKeys& quick_keys() {
    static const TableKeys keys = with("quick", {});
    return keys;
}

const TableKeys& chart_keys() {
    static const TableKeys keys =
        with("chart", {{"error", TablesRule{error_keys}, "one chart each"}});
    return keys;
}

const TableKeys& charted_case_keys() {
    static const TableKeys keys = [] {
        TableKeys both = with("charted case", suite_keys());
        both.keys.push_back(chart_keys().keys.back());
        return both;
    }();
    return keys;
}

const TableKeys& observable_keys() {
    static const TableKeys keys{
        .name = "observable",
        .keys = {{"name", TextRule{TextKind::name}, "of `crossgrain observables`", required}},
        .others = {
            {"option", {TextRule{}, toml_input::NumbersRule{Range::any()}}, "of that observable"}}};
    return keys;
}

}  // namespace crossgrain::catalog
