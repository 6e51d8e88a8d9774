#include "cases/catalog/variant_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fnmatch.h>

#include <algorithm>

namespace crossgrain::catalog {
namespace {

using toml_input::TomlTable;

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

}  // namespace

std::vector<Variant> read_written_variants(const TomlTable& t) {
    std::vector<Variant> variants;
    for (const TomlTable& entry : t.tables("variant")) {
        Variant variant{.name = entry.text("name"), .not_expressible_in = {}};
        if (entry.has("not_expressible_in")) {
            variant.not_expressible_in = entry.texts("not_expressible_in");
        }
        variant.drops = entry.optional_text("drops").value_or("");
        (void)entry.table("scene");  // read by Case::scene
        entry.reject_unknown_keys();
        const bool repeated =
            std::any_of(variants.begin(), variants.end(),
                        [&](const Variant& other) { return other.name == variant.name; });
        if (repeated) {
            throw entry.error("name", "is taken", fmt::format("\"{}\"", variant.name),
                              "a name of its own for each variant");
        }
        variants.push_back(std::move(variant));
    }
    if (variants.empty()) variants.push_back({.name = "", .drops = {}, .not_expressible_in = {}});
    return variants;
}

std::vector<Variant> cross(const Sweep& sweep, const std::vector<Variant>& written) {
    std::vector<Variant> variants;
    for (const SweepPoint& point : sweep.points) {
        for (Variant variant : written) {
            const bool both = !point.name.empty() && !variant.name.empty();
            variant.name = point.name + (both ? "/" : "") + variant.name;
            variant.parameters = point.parameters;
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
