// Checks against trends of the literature: a quantity over the variants of a sweep.
#include "reference/judge/evaluate.hpp"

#include "reference/compare/trend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

/// Variants that differ in the key of the trend only.
struct Group {
    std::string name;  ///< what they share
    std::vector<std::size_t> variants;
};

/// The variant's name without the component of the key.
std::string shared_name(const catalog::Variant& variant, const std::string& key) {
    const std::string component = fmt::format("{}={}", key, *variant.parameter(key));
    std::string name = variant.name;
    const auto at = name.find(component);
    name.erase(at, component.size());
    if (at < name.size() && name[at] == '/') {
        name.erase(at, 1);
    } else if (at > 0) {
        name.erase(at - 1, 1);
    }
    return name;
}

std::vector<Group> groups_of(const catalog::Case& the_case, const catalog::Check& check) {
    std::vector<Group> groups;
    for (const std::size_t variant : variants_of(the_case, check)) {
        if (!the_case.variants[variant].parameter(check.along)) continue;
        const std::string name = shared_name(the_case.variants[variant], check.along);
        auto found = std::find_if(groups.begin(), groups.end(),
                                  [&](const Group& group) { return group.name == name; });
        if (found == groups.end()) found = groups.insert(groups.end(), Group{name, {}});
        found->variants.push_back(variant);
    }
    return groups;
}

compare::Trend trend_of(catalog::Aspect aspect) {
    if (aspect == catalog::Aspect::constant) return compare::Trend::constant;
    return aspect == catalog::Aspect::increasing ? compare::Trend::increasing
                                                 : compare::Trend::decreasing;
}

std::string word_of(catalog::Aspect aspect) {
    if (aspect == catalog::Aspect::constant) return "constant";
    return aspect == catalog::Aspect::increasing ? "increasing" : "decreasing";
}

void judge(const CaseRuns& runs, const catalog::Check& check, const Group& group,
           compare::Verdict& verdict) {
    const std::size_t first = group.variants.front();
    std::vector<compare::TrendPoint> points;
    for (const std::size_t variant : group.variants) {
        const auto& name = runs.the_case().variants[variant].name;
        if (const auto absence = runs.absence(verdict.code, variant)) {
            return set_outcome(runs, check, first, "", absence->outcome,
                               fmt::format("{}: {}", name, absence->reason), verdict);
        }
        const auto combined = runs.combined(verdict.code, variant, 0, check.observable);
        if (!combined) {
            return set_outcome(runs, check, first, "", Outcome::undecided,
                               fmt::format("{}: '{}' was not measured", name, check.observable),
                               verdict);
        }
        points.push_back(
            {.at = std::stod(*runs.the_case().variants[variant].parameter(check.along)),
             .value = combined->measurement.value,
             .standard_error = combined->measurement.standard_error,
             .degrees_of_freedom = combined->degrees_of_freedom});
    }
    if (points.size() < 2) {
        return set_outcome(runs, check, first, "", Outcome::undecided, "one point shows no trend",
                           verdict);
    }
    const auto answer = compare::judge_trend(trend_of(check.aspect), points, check.limit);
    verdict.difference = answer.difference;
    verdict.uncertainty = answer.half_width_95;
    set_outcome(runs, check, first, "", answer.outcome, answer.reason, verdict);
}

}  // namespace

void evaluate_trend(const CaseRuns& runs, const catalog::Check& check,
                    const published::PublishedValues& literature, Evaluation& evaluation) {
    const auto reference = literature.find(check.against.name);
    for (const Group& group : groups_of(runs.the_case(), check)) {
        for (const auto& code : codes_of(runs, check)) {
            auto verdict = blank_verdict(runs.the_case(), check, code, group.variants.front());
            verdict.variant = group.name;
            if (!reference || reference->trend != word_of(check.aspect)) {
                set_outcome(runs, check, group.variants.front(), "", Outcome::no_reference,
                            fmt::format("no published trend '{}' that is {}", check.against.name,
                                        word_of(check.aspect)),
                            verdict);
            } else {
                judge(runs, check, group, verdict);
            }
            evaluation.verdicts.push_back(std::move(verdict));
        }
    }
}

}  // namespace crossgrain::judge
