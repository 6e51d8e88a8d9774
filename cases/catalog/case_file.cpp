#include "cases/catalog/case.hpp"

#include "cases/catalog/case_keys.hpp"
#include "cases/catalog/check_file.hpp"
#include "cases/catalog/fit_file.hpp"
#include "cases/catalog/sweep_file.hpp"
#include "cases/catalog/variant_file.hpp"
#include "cases/scene/model_file.hpp"
#include "cases/scene/scene_file.hpp"
#include "cases/toml/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace crossgrain::catalog {

using toml_input::KeyedTable;
using toml_input::TomlTable;

/// The parsed file and, per variant, the layers of [scene] from the top: variant, sweep, suite,
/// case. Variants are the points of the sweep, each in every written [[variant]].
struct Case::Source {
    std::shared_ptr<const toml::table> root;
    const toml::table* suite = nullptr;  ///< [quick] or [chart], when it is that suite
    std::string file;
    std::string readings;
    Sweep sweep;

    [[nodiscard]] TomlTable scene_table(const Variant& variant) const;
    /// Values of a sweep have lost their place in the file: it is put back.
    [[nodiscard]] CaseError placed(const CaseError& error) const;
};

namespace {

const toml::table* sub_table(const toml::table& parent, std::string_view key) {
    const auto* node = parent.get(key);
    return node == nullptr ? nullptr : node->as_table();
}

std::vector<std::string> read_suites(const KeyedTable& t, const toml::table& root) {
    auto suites = t.texts("suites");
    if (sub_table(root, "chart") != nullptr) suites.emplace_back("chart");
    return suites;
}

/// The table laid over the case in a suite; none in the full one.
std::string layer_of(Suite suite) {
    return suite == Suite::full ? "" : to_string(suite);
}

/// A chart has a ladder of its own; the quick suite has other values of the case's keys.
Sweep sweep_of(const Case::Source& source, Suite suite, const std::vector<std::string>& axes) {
    const auto* base = sub_table(*source.root, "sweep");
    const auto* layered = source.suite == nullptr ? nullptr : sub_table(*source.suite, "sweep");
    if (suite == Suite::chart) return read_sweep(layered, nullptr, source.file, axes);
    return read_sweep(base, layered, source.file, axes);
}

std::vector<ChartedError> read_charted(const KeyedTable& t) {
    std::vector<ChartedError> charted;
    for (const KeyedTable& entry : t.tables("error")) {
        charted.push_back({.observable = entry.text("observable"),
                           .against = read_reference(
                               entry, {Reference::Kind::closed_form, Reference::Kind::converged}),
                           .margin = entry.number("margin"),
                           .reason = entry.text("reason"),
                           .line = entry.line()});
        entry.reject_unknown_keys();
    }
    return charted;
}

Replicas read_replicas(const KeyedTable& t) {
    Replicas replicas;
    for (const auto& key : t.names()) {
        const std::int64_t count = t.integer(key);
        if (key == "default") {
            replicas.standard = count;
        } else {
            replicas.by_code[key] = count;
        }
    }
    return replicas;
}

std::vector<ObservableRequest> read_observables(const KeyedTable& t) {
    std::vector<ObservableRequest> requests;
    for (const KeyedTable& entry : t.tables("observable")) {
        ObservableRequest request{
            .name = entry.text("name"), .options = {}, .line = entry.line(), .column = 1};
        for (const auto& key : entry.names()) {
            if (key == "name") continue;
            const CaseError at = entry.error(key, "", "", "");
            Option option{.line = at.details().line, .column = at.details().column};
            if (entry.is_text(key)) {
                option.text = entry.text(key);
            } else {
                option.numbers = entry.numbers(key);
            }
            request.options.emplace(key, std::move(option));
        }
        requests.push_back(std::move(request));
    }
    return requests;
}

void check_every_scene(Case& the_case) {
    for (std::size_t v = 0; v < the_case.variants.size(); ++v) {
        Variant& variant = the_case.variants[v];
        for (std::size_t rung = 0; rung < variant.rungs; ++rung)
            variant.bytes += scene::bytes_of(the_case.scene(v, rung, 1));
    }
}

}  // namespace

TomlTable Case::Source::scene_table(const Variant& variant) const {
    std::vector<const toml::table*> layers;
    const auto add = [&](const toml::table* owner) {
        if (owner == nullptr) return;
        if (const auto* layer = sub_table(*owner, "scene")) layers.push_back(layer);
    };
    const bool own_variants = suite != nullptr && suite->contains("variant");
    if (const auto* entries = (own_variants ? *suite : *root).get("variant")) {
        if (const auto* array = entries->as_array()) add((*array)[variant.written].as_table());
    }
    layers.push_back(&sweep.points[variant.point].scene);
    add(suite);
    add(root.get());
    return {file, "scene", std::move(layers)};
}

CaseError Case::Source::placed(const CaseError& error) const {
    CaseErrorDetails details = error.details();
    for (const auto& [key, line] : sweep.lines) {
        if (details.line == 0 && details.key == "scene." + key) details.line = line;
    }
    return CaseError(details);
}

scene::AnyScene Case::scene(std::size_t variant, std::size_t rung, std::uint64_t seed) const {
    std::string full_name = name;
    if (!variants[variant].name.empty()) full_name += "/" + variants[variant].name;
    if (variants[variant].rungs > 1) full_name += fmt::format("/{}", rung + 1);
    const TomlTable table = parsed->scene_table(variants[variant]);
    const scene::SceneSelection selection{
        .name = full_name, .rung = rung, .seed = seed, .readings = parsed->readings};
    try {
        if (model == "lattice-gas") return scene::read_lattice_gas(table, selection);
        if (model == "hopper-automaton") return scene::read_hopper_automaton(table, selection);
        if (model == "synthetic-signal") return scene::read_synthetic_signal(table, selection);
        return scene::read_scene(table, selection);
    } catch (const CaseError& error) {
        throw parsed->placed(error);
    }
}

scene::Scene Case::grain_scene(std::size_t variant, std::size_t rung, std::uint64_t seed) const {
    return std::get<scene::Scene>(scene(variant, rung, seed));
}

namespace {

void count_rungs(Case& the_case, const Case::Source& source) {
    if (the_case.model != models().front().name) return;  // only grains have ladders of time steps
    for (Variant& variant : the_case.variants) {
        try {
            variant.rungs = scene::ladder_size(source.scene_table(variant));
        } catch (const CaseError& error) {
            throw source.placed(error);
        }
    }
}

/// Nothing would read the table of a suite within that of another.
void check_no_suite_inside(const Case::Source& source, Suite suite) {
    if (source.suite == nullptr) return;
    for (const Suite inner : {Suite::quick, Suite::chart}) {
        const auto* there = source.suite->get(layer_of(inner));
        if (there == nullptr) continue;
        throw CaseError({.file = source.file,
                         .line = static_cast<int>(there->source().begin.line),
                         .key = fmt::format("{}.{}", layer_of(suite), layer_of(inner)),
                         .problem = "is a suite within a suite",
                         .expected = fmt::format("[{}] by itself", layer_of(inner))});
    }
}

/// A case from its parsed file, which is read once: it may be a pipe.
Case case_from(const std::shared_ptr<const toml::table>& root, const std::string& file, Suite suite,
               const std::string& readings, const std::vector<std::string>& axes) {
    auto source = std::make_shared<Case::Source>();
    source->root = root;
    source->file = file;
    source->readings = readings;
    source->suite = sub_table(*root, layer_of(suite));
    if (suite == Suite::chart && source->suite == nullptr) {
        throw CaseError({.file = file,
                         .key = layer_of(suite),
                         .problem = "is missing",
                         .expected = fmt::format("a table [{}] with a sweep", layer_of(suite)),
                         .hint = "see cases/catalog/README.md"});
    }
    std::vector<const toml::table*> layers{root.get()};
    if (source->suite != nullptr) layers.insert(layers.begin(), source->suite);
    source->sweep = sweep_of(*source, suite, axes);
    check_no_suite_inside(*source, suite);
    const bool charted = suite == Suite::chart;
    const KeyedTable t(TomlTable(file, "", layers), charted ? charted_case_keys() : case_keys());
    Case result;
    result.file = file;
    result.name = t.text("name");
    result.title = t.text("title");
    result.source = t.text("source");
    result.text = t.text("text");
    result.suites = read_suites(t, *root);
    result.time_limit = t.number("time_limit");
    if (t.has("model")) result.model = models()[t.choice("model")].name;
    result.failure_map = t.optional_text("failure_map").value_or("");
    result.variants = cross(file, source->sweep, read_written_variants(t));
    result.replicas = read_replicas(t.table("replicas"));
    const KeyedTable more = t.table("replicas_in");
    for (const auto& pattern : more.names())
        result.replicas.times_in[pattern] = more.integer(pattern);
    result.observables = read_observables(t);
    result.fits = read_fits(t);
    result.checks = read_checks(t);
    if (charted) {
        result.checks.clear();
        result.charted = read_charted(t);
    }
    for (const char* elsewhere : {"quick", "chart", "scene", "sweep"})
        t.check_table(elsewhere);
    count_rungs(result, *source);
    t.reject_unknown_keys();
    result.parsed = std::move(source);
    if (suite == Suite::full) check_variant_names(result);
    check_runs(result, {});
    check_every_scene(result);
    check_runs(result, {});  // now that the scenes' sizes are known
    // What only another suite reads must not wait for it to be found wrong.
    for (const Suite other : {Suite::quick, Suite::chart}) {
        if (suite == Suite::full && root->contains(layer_of(other))) {
            (void)case_from(root, file, other, readings, {});
        }
    }
    return result;
}

}  // namespace

Case load_case(const std::string& file, Suite suite, const std::string& readings,
               const std::vector<std::string>& axes, std::stop_token stop) {
    const auto root =
        std::make_shared<const toml::table>(toml_input::parse_toml_file(file, std::move(stop)));
    return case_from(root, file, suite, readings, axes);
}

std::vector<std::string> case_names(const std::string& directory) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

Case find_case(const std::string& directory, const std::string& name, Suite suite,
               const std::vector<std::string>& axes, std::stop_token stop) {
    const std::string readings = (std::filesystem::path(directory) / "readings").string();
    if (name.find('/') != std::string::npos || name.ends_with(".toml")) {
        return load_case(name, suite, readings, axes, std::move(stop));
    }
    const std::vector<std::string> names = case_names(directory);
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        const auto near = toml_input::nearest(name, names);
        throw CaseError({.problem = "unknown case",
                         .got = fmt::format("'{}'", name),
                         .expected = "a name from 'crossgrain cases' or the path of a case file",
                         .hint = near ? fmt::format("did you mean '{}'?", *near) : ""});
    }
    return load_case((std::filesystem::path(directory) / (name + ".toml")).string(), suite,
                     readings, axes, std::move(stop));
}

}  // namespace crossgrain::catalog
