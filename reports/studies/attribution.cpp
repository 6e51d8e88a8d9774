#include "reports/studies/attribution.hpp"

#include "cases/scene/friction.hpp"
#include "reports/documents/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace crossgrain::studies {
namespace {

using nlohmann::json;
using numerics::MeanWithError;

const std::string engine = "native-dem";
const std::array<std::string, 4> keys{"velocity_lever", "torque_lever", "rotation", "limit"};
const std::array<std::string, 4> laws{"lammps-granular", "lammps-hooke-history", "liggghts",
                                      "yade"};
const std::array<std::string, 3> attributed{"granular_temperature", "mean_square_spin",
                                            "mean_speed"};
constexpr std::size_t least_replicas = 4;

/// The words of a combination, in the order of `keys`.
using Combination = std::array<std::string, 4>;

Combination combination_of(const std::string& law) {
    const auto c = scene::conventions_named(law).value();
    return {to_string(c.velocity_lever), to_string(c.torque_lever), to_string(c.rotation),
            to_string(c.limit)};
}

bool sweeps_conventions(const catalog::Case& the_case) {
    const auto& first = the_case.variants.front();
    return std::ranges::all_of(keys,
                               [&](const auto& key) { return first.parameter(key).has_value(); });
}

std::optional<std::size_t> variant_of(const catalog::Case& the_case, const Combination& words) {
    for (std::size_t v = 0; v < the_case.variants.size(); ++v) {
        bool same = true;
        for (std::size_t k = 0; k < keys.size(); ++k)
            same = same && the_case.variants[v].parameter(keys[k]) == words[k];
        if (same) return v;
    }
    return std::nullopt;
}

/// Variants of all combinations between a and b: bit i of the index turns the i-th key in which
/// they differ. Empty if the case lacks one.
std::vector<std::size_t> variants_between(const catalog::Case& the_case, const Combination& a,
                                          const Combination& b) {
    std::vector<std::size_t> differing, variants;
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (a[k] != b[k]) differing.push_back(k);
    for (std::size_t turned = 0; turned < std::size_t{1} << differing.size(); ++turned) {
        Combination words = a;
        for (std::size_t i = 0; i < differing.size(); ++i)
            if ((turned >> i & 1U) != 0) words[differing[i]] = b[differing[i]];
        const auto variant = variant_of(the_case, words);
        if (!variant) return {};
        variants.push_back(*variant);
    }
    return variants;
}

const measure::Measurement* measured(const judge::CaseRuns& runs, std::size_t variant,
                                     std::int64_t replica, const std::string& observable) {
    const auto* record = runs.find(engine, variant, 0, replica);
    if (record == nullptr) return nullptr;
    const auto& all = record->results.measurements;
    const auto found = std::ranges::find(all, observable, &measure::Measurement::observable);
    return found == all.end() ? nullptr : &*found;
}

/// From the replicas that all combinations have.
std::optional<AttributedObservable> attributed_observable(const judge::CaseRuns& runs,
                                                          const std::vector<std::size_t>& variants,
                                                          const std::string& observable) {
    AttributedObservable result{.observable = observable, .unit = {}, .attribution = {}};
    std::vector<std::vector<double>> values(variants.size());
    const std::int64_t replicas = runs.replicas(engine, variants.front(), 0);
    for (std::int64_t replica = 0; replica < replicas; ++replica) {
        std::vector<double> of_replica;
        for (const std::size_t variant : variants) {
            const auto* m = measured(runs, variant, replica, observable);
            if (m == nullptr) break;
            of_replica.push_back(m->value);
            result.unit = m->unit;
        }
        if (of_replica.size() < variants.size()) continue;
        for (std::size_t v = 0; v < variants.size(); ++v)
            values[v].push_back(of_replica[v]);
    }
    if (values.front().size() < least_replicas) return std::nullopt;
    result.attribution = compare::attribute(values);
    return result;
}

std::optional<AttributedPair> attributed_pair(const judge::CaseRuns& runs, const std::string& a,
                                              const std::string& b) {
    const auto from = combination_of(a), to = combination_of(b);
    const auto variants = variants_between(runs.the_case(), from, to);
    if (variants.empty()) return std::nullopt;
    AttributedPair pair{
        .case_name = runs.the_case().name, .a = a, .b = b, .switches = {}, .observables = {}};
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (from[k] != to[k]) pair.switches.push_back({keys[k], from[k], to[k]});
    for (const auto& name : attributed) {
        if (auto observable = attributed_observable(runs, variants, name)) {
            pair.observables.push_back(std::move(*observable));
        }
    }
    if (pair.observables.empty()) return std::nullopt;
    return pair;
}

std::vector<AttributedPair> all_pairs(const session::SessionReport& report) {
    std::vector<AttributedPair> all;
    for (const auto& item : report.cases) {
        auto pairs = attribute_conventions(item.runs);
        std::ranges::move(pairs, std::back_inserter(all));
    }
    return all;
}

/// "velocity lever" of "velocity_lever".
std::string words_of(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

/// What a difference is stated in percent of.
double scale_of(const compare::Attribution& attribution) {
    return std::abs(attribution.a.value + attribution.b.value) / 2 / 100;
}

std::string percent(const numerics::MeanWithError& mean, double scale) {
    return fmt::format("{:+.2f} +- {:.2f}", mean.value / scale, mean.standard_error / scale);
}

/// Contributions by key: a key in which the two do not differ has none.
std::vector<std::string> row_of(const AttributedPair& pair, const AttributedObservable& item) {
    const auto& found = item.attribution;
    const double scale = scale_of(found);
    std::vector<std::string> row{fmt::format("{}, {}", pair.a, pair.b), words_of(item.observable),
                                 percent(found.difference, scale)};
    for (const auto& key : keys) {
        const auto at = std::ranges::find(pair.switches, key, &ConventionSwitch::key);
        if (at == pair.switches.end()) {
            row.emplace_back("-");
            continue;
        }
        const auto& c = found.contributions[static_cast<std::size_t>(at - pair.switches.begin())];
        row.push_back(percent(c.average, scale) + (c.significant ? " *" : ""));
    }
    row.push_back(pair.switches.size() < 2 ? "-" : percent(found.interaction, scale));
    return row;
}

/// "liggghts and yade differ by 2.0 +- 0.3 % in mean speed: rotation 2.0", largest first; empty
/// for a difference that is not significant.
std::string sentence(const AttributedPair& pair, const AttributedObservable& item) {
    const auto& found = item.attribution;
    if (!found.significant) return {};
    const double difference = found.difference.value;
    const double scale = std::copysign(scale_of(found), difference);
    std::vector<std::pair<double, std::string>> parts;
    for (std::size_t i = 0; i < pair.switches.size(); ++i)
        parts.emplace_back(found.contributions[i].average.value / scale, pair.switches[i].key);
    std::ranges::sort(parts, std::greater<>(), [](const auto& p) { return std::abs(p.first); });
    std::string text;
    for (const auto& [value, key] : parts)
        text += fmt::format("{}{} {:.1f}", text.empty() ? "" : ", ", words_of(key), value);
    return fmt::format("{} and {} differ by {:.1f} +- {:.1f} % in {} ({} is larger): {}\n", pair.a,
                       pair.b, difference / scale,
                       found.difference.standard_error / std::abs(scale), words_of(item.observable),
                       difference > 0 ? pair.b : pair.a, text);
}

/// A line for each case of conventions without a single pair.
std::string missing_runs(const session::SessionReport& report) {
    std::string text;
    for (const auto& item : report.cases) {
        const bool missing =
            sweeps_conventions(*item.the_case) && attribute_conventions(item.runs).empty();
        if (!missing) continue;
        text += fmt::format("{}: no attribution: it needs {} replicas or more of {} in every "
                            "combination of conventions\n",
                            item.the_case->name, least_replicas, engine);
    }
    return text;
}

json mean_json(const numerics::MeanWithError& mean) {
    return {{"value", mean.value}, {"stderr", mean.standard_error}};
}

json observable_json(const AttributedPair& pair, const AttributedObservable& item) {
    const auto& found = item.attribution;
    json contributions = json::array();
    for (std::size_t i = 0; i < pair.switches.size(); ++i) {
        const auto& c = found.contributions[i];
        contributions.push_back({{"switch", pair.switches[i].key},
                                 {"average", mean_json(c.average)},
                                 {"first", mean_json(c.first)},
                                 {"last", mean_json(c.last)},
                                 {"significant", c.significant}});
    }
    return {{"observable", item.observable},
            {"unit", item.unit},
            {"replicas", found.difference.n},
            {"a", mean_json(found.a)},
            {"b", mean_json(found.b)},
            {"difference", mean_json(found.difference)},
            {"significant", found.significant},
            {"contributions", std::move(contributions)},
            {"interaction", mean_json(found.interaction)}};
}

}  // namespace

std::vector<AttributedPair> attribute_conventions(const judge::CaseRuns& runs) {
    std::vector<AttributedPair> pairs;
    if (!sweeps_conventions(runs.the_case())) return pairs;
    for (std::size_t a = 0; a < laws.size(); ++a) {
        for (std::size_t b = a + 1; b < laws.size(); ++b) {
            if (auto pair = attributed_pair(runs, laws[a], laws[b])) {
                pairs.push_back(std::move(*pair));
            }
        }
    }
    return pairs;
}

std::string attribution_table(const session::SessionReport& report) {
    std::vector<std::string> header{"conventions", "observable", "difference %"};
    std::ranges::transform(keys, std::back_inserter(header), words_of);
    header.emplace_back("interaction");
    reports::TextTable table(header);
    std::string sentences;
    for (const auto& pair : all_pairs(report)) {
        for (const auto& item : pair.observables) {
            table.add(row_of(pair, item));
            sentences += sentence(pair, item);
        }
    }
    if (table.empty()) return missing_runs(report);
    return fmt::format(
        "\n{}, one convention switched at a time: second code minus first, in percent "
        "of their mean\n(average over the orders of switching; * differs from 0 at "
        "95 %; interaction: beyond what each makes alone)\n{}\n{}{}",
        engine, table.text(0), sentences, missing_runs(report));
}

json attribution_document(const session::SessionReport& report) {
    json document = json::array();
    for (const auto& pair : all_pairs(report)) {
        json switches = json::array(), observables = json::array();
        for (const auto& s : pair.switches)
            switches.push_back({{"switch", s.key}, {"from", s.from}, {"to", s.to}});
        for (const auto& item : pair.observables)
            observables.push_back(observable_json(pair, item));
        document.push_back({{"case", pair.case_name},
                            {"a", pair.a},
                            {"b", pair.b},
                            {"code", engine},
                            {"switches", std::move(switches)},
                            {"observables", std::move(observables)}});
    }
    return document;
}

}  // namespace crossgrain::studies
