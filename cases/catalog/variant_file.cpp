#include "cases/catalog/variant_file.hpp"

#include "native/base/printable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fnmatch.h>

#include <algorithm>
#include <set>

namespace crossgrain::catalog {
namespace {

using toml_input::KeyedTable;
using toml_input::TableKeys;
using toml_input::TextRule;
using toml_input::TextsRule;

void require_variant(const Case& the_case, int line, const char* key, const std::string& pattern) {
    std::vector<std::string> names;
    for (const auto& variant : the_case.variants) {
        if (matches(pattern, variant.name)) return;
        names.push_back(variant.name);
    }
    throw CaseError({.file = the_case.file,
                     .line = line,
                     .key = key,
                     .problem = "names no variant",
                     .got = fmt::format("\"{}\"", pattern),
                     .expected = fmt::format("one of {}", fmt::join(names, ", "))});
}

std::map<std::string, std::vector<std::string>> read_only(const KeyedTable& entry) {
    std::map<std::string, std::vector<std::string>> only;
    const KeyedTable t = entry.table("only");
    for (const auto& key : t.names())
        only[key] = t.texts(key);
    return only;
}

const TableKeys& only_keys() {
    static const TableKeys keys{
        .name = "variant.only",
        .keys = {},
        .others = {{"key of the sweep", TextsRule{}, "its values, as texts"}}};
    return keys;
}

/// Every value that the variant is limited to must be one of the sweep's.
void require_points(const std::string& file, const Variant& variant, const Sweep& sweep) {
    for (const auto& [key, values] : variant.only) {
        for (const auto& value : values) {
            const std::pair wanted(key, value);
            const bool there = std::ranges::any_of(sweep.points, [&](const SweepPoint& point) {
                return std::ranges::find(point.parameters, wanted) != point.parameters.end();
            });
            if (there) continue;
            throw CaseError({.file = file,
                             .key = "variant.only." + key,
                             .problem = fmt::format("of '{}' is not in the sweep", variant.name),
                             .got = fmt::format("\"{}\"", value),
                             .expected = "a key of [sweep] with some of its values, as texts"});
        }
    }
}

/// Parts that are short may make a long name; parts with a '/' may make the same name twice.
void check_full_name(const std::string& file, const std::string& name,
                     std::set<std::string>& names) {
    constexpr std::size_t longest = 400;
    const bool taken = !names.insert(name).second;
    if (!taken && name.size() <= longest) return;
    throw CaseError({.file = file,
                     .key = "variant",
                     .problem = taken ? "has a name twice" : "has too long a name",
                     .got = fmt::format("'{}'", printable(name, longest)),
                     .expected = taken ? "names and values that tell the variants apart"
                                       : fmt::format("at most {} bytes", longest)});
}

bool is_made_at(const Variant& variant, const SweepPoint& point) {
    return std::ranges::all_of(point.parameters, [&](const auto& parameter) {
        const auto wanted = variant.only.find(parameter.first);
        return wanted == variant.only.end() ||
               std::ranges::find(wanted->second, parameter.second) != wanted->second.end();
    });
}

}  // namespace

const TableKeys& variant_keys() {
    static const TableKeys keys{
        .name = "variant",
        .keys = {{"name", TextRule{}, "of its own", toml_input::Need::required},
                 {"scene", toml_input::SceneRule{}, "keys that are laid over [scene]"},
                 {"not_expressible_in", TextsRule{.names = "code"}, "gaps that are known"},
                 {"drops", TextRule{}, "physics that it leaves out, e.g. \"spins\""},
                 {"only", toml_input::TableRule{only_keys},
                  "points of the sweep at which alone it is made"}}};
    return keys;
}

std::vector<Variant> read_written_variants(const KeyedTable& t) {
    std::vector<Variant> variants;
    std::set<std::string> names;
    for (const KeyedTable& entry : t.tables("variant")) {
        Variant variant{.name = entry.text("name"), .not_expressible_in = {}};
        const auto fault = toml_input::fault_in(variant.name, toml_input::TextKind::name);
        if (!variant.name.empty() && fault)  // one may be plain
            throw entry.error("name", fault->problem, fault->got, fault->expected);
        if (entry.has("not_expressible_in")) {
            variant.not_expressible_in = entry.texts("not_expressible_in");
        }
        variant.drops = entry.optional_text("drops").value_or("");
        variant.only = read_only(entry);
        entry.check_table("scene");  // read by Case::scene
        entry.reject_unknown_keys();
        if (!names.insert(variant.name).second) {
            throw entry.error("name", "is taken", fmt::format("\"{}\"", variant.name),
                              "a name of its own for each variant");
        }
        variants.push_back(std::move(variant));
    }
    if (variants.empty()) variants.push_back({.name = "", .drops = {}, .not_expressible_in = {}});
    return variants;
}

std::vector<Variant> cross(const std::string& file, const Sweep& sweep,
                           const std::vector<Variant>& written) {
    std::vector<Variant> variants;
    if (sweep.points.size() * written.size() > most_runs) {
        throw CaseError({.file = file,
                         .key = "variant",
                         .problem = "makes too many runs",
                         .got = fmt::format("{} variants at {} points of the sweep", written.size(),
                                            sweep.points.size()),
                         .expected = fmt::format("at most {} runs in a case", most_runs)});
    }
    for (const Variant& variant : written)
        require_points(file, variant, sweep);
    std::set<std::string> names;
    for (std::size_t p = 0; p < sweep.points.size(); ++p) {
        const SweepPoint& point = sweep.points[p];
        for (std::size_t w = 0; w < written.size(); ++w) {
            if (!is_made_at(written[w], point)) continue;
            Variant variant = written[w];
            variant.point = p;
            variant.written = w;
            const bool both = !point.name.empty() && !variant.name.empty();
            variant.name = point.name + (both ? "/" : "") + variant.name;
            variant.parameters = point.parameters;
            check_full_name(file, variant.name, names);
            variants.push_back(std::move(variant));
        }
    }
    return variants;
}

std::optional<std::string> Variant::parameter(const std::string& key) const {
    for (const auto& [swept, value] : parameters) {
        if (swept == key) return value;
    }
    return std::nullopt;
}

bool matches(const std::string& pattern, const std::string& name) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

void check_variant_names(const Case& the_case) {
    for (const auto& [pattern, times] : the_case.replicas.times_in)
        require_variant(the_case, 0, "replicas_in", pattern);
    for (const auto& check : the_case.checks) {
        for (const auto& pattern : check.variants)
            require_variant(the_case, check.line, "check.variants", pattern);
        for (const auto& name : check.between)
            require_variant(the_case, check.line, "check.between", name);
        for (const auto& [pattern, outcome] : check.expect_in)
            require_variant(the_case, check.line, "check.expect_in", pattern);
        if (!is_trend(check.aspect)) continue;
        const auto& parameters = the_case.variants.front().parameters;
        const bool swept = std::any_of(parameters.begin(), parameters.end(),
                                       [&](const auto& p) { return p.first == check.along; });
        if (swept) continue;
        throw CaseError({.file = the_case.file,
                         .line = check.line,
                         .key = "check.along",
                         .problem = "is not a key of [sweep]",
                         .got = fmt::format("\"{}\"", check.along),
                         .expected = "one of the sweep's keys"});
    }
}

}  // namespace crossgrain::catalog
