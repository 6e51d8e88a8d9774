// The loop of the judge: a check is asked in each of its places, of each of its codes or pairs.
#include "reference/judge/question.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

/// Where a check is asked: a variant, two that are compared, or those of a sweep.
struct Place {
    std::string name;  ///< of the variant, or what those of a sweep share; may be empty
    std::vector<std::size_t> variants;
};

/// Variants a check applies to; the first one for what is fitted over all of them.
std::vector<std::size_t> variants_of(const catalog::Case& the_case, const catalog::Check& check) {
    if (is_fitted(the_case, check.observable)) return {0};
    std::vector<std::size_t> result;
    for (std::size_t variant = 0; variant < the_case.variants.size(); ++variant) {
        const bool asked =
            check.variants.empty() || std::ranges::any_of(check.variants, [&](const auto& pattern) {
                return catalog::matches(pattern, the_case.variants[variant].name);
            });
        if (asked) result.push_back(variant);
    }
    return result;
}

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

/// Variants that differ in the key of the trend only are one place.
std::vector<Place> sweeps_of(const catalog::Case& the_case, const catalog::Check& check) {
    std::vector<Place> sweeps;
    for (const std::size_t variant : variants_of(the_case, check)) {
        if (!the_case.variants[variant].parameter(check.along)) continue;
        const std::string name = shared_name(the_case.variants[variant], check.along);
        auto found = std::ranges::find(sweeps, name, &Place::name);
        if (found == sweeps.end()) found = sweeps.insert(sweeps.end(), Place{name, {}});
        found->variants.push_back(variant);
    }
    return sweeps;
}

std::vector<Place> places_of(const catalog::Case& the_case, const catalog::Check& check) {
    if (catalog::is_trend(check.aspect)) return sweeps_of(the_case, check);
    std::vector<Place> places;
    if (check.between.empty()) {
        for (const std::size_t variant : variants_of(the_case, check))
            places.push_back({the_case.variants[variant].name, {variant}});
    } else {
        Place both{check.between[0], {}};
        for (const auto& name : check.between) {
            const auto found = std::ranges::find(the_case.variants, name, &catalog::Variant::name);
            if (found == the_case.variants.end()) return {};  // left out of the quick suite
            both.variants.push_back(static_cast<std::size_t>(found - the_case.variants.begin()));
        }
        places.push_back(std::move(both));
    }
    if (is_fitted(the_case, check.observable)) {
        for (Place& place : places)
            place.name.clear();
    }
    return places;
}

struct Codes {
    std::string code, other;
};

/// Codes of the runs a check applies to, in their order, or all pairs of them.
std::vector<Codes> codes_of(const CaseRuns& runs, const catalog::Check& check,
                            compare::Against::Kind against) {
    std::vector<std::string> codes;
    std::ranges::copy_if(runs.codes(), std::back_inserter(codes), [&](const auto& code) {
        return check.codes.empty() || std::ranges::find(check.codes, code) != check.codes.end();
    });
    std::vector<Codes> result;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        if (against != compare::Against::Kind::code) {
            result.push_back({codes[i], ""});
            continue;
        }
        for (std::size_t j = i + 1; j < codes.size(); ++j)
            result.push_back({codes[i], codes[j]});
    }
    return result;
}

double limit_of(const catalog::Check& check, const Codes& codes) {
    double limit = check.limit;
    if (codes.other.empty()) return limit;
    for (const auto& code : {codes.code, codes.other}) {
        if (const auto found = check.limit_for.find(code); found != check.limit_for.end()) {
            limit = std::max(limit, found->second);
        }
    }
    return limit;
}

/// What the check names; of a pair the second code is not known yet.
compare::Against against_of(const catalog::Check& check) {
    using Kind = compare::Against::Kind;
    if (!check.between.empty()) return {Kind::variant, check.between[1]};
    if (!check.with.empty()) return {Kind::own_observable, check.with};
    if (check.kind == catalog::CheckKind::exact) {
        return {Kind::closed_form, to_string(check.against)};
    }
    if (check.kind != catalog::CheckKind::published) return {Kind::code, ""};
    return {catalog::is_trend(check.aspect) ? Kind::trend : Kind::published,
            to_string(check.against)};
}

compare::Kind kind_of(catalog::CheckKind kind) {
    switch (kind) {
    case catalog::CheckKind::exact:
        return compare::Kind::exact;
    case catalog::CheckKind::parity:
        return compare::Kind::parity;
    case catalog::CheckKind::agree:
        return compare::Kind::agree;
    case catalog::CheckKind::published:
        break;
    }
    return compare::Kind::published;
}

compare::Aspect aspect_of(catalog::Aspect aspect) {
    switch (aspect) {
    case catalog::Aspect::value:
        break;
    case catalog::Aspect::limit:
        return compare::Aspect::limit;
    case catalog::Aspect::order:
        return compare::Aspect::order;
    case catalog::Aspect::constant:
        return compare::Aspect::constant;
    case catalog::Aspect::increasing:
        return compare::Aspect::increasing;
    case catalog::Aspect::decreasing:
        return compare::Aspect::decreasing;
    }
    return compare::Aspect::value;
}

std::string rule_variant_of(const catalog::Variant& variant) {
    if (variant.parameters.empty()) return {};
    const auto& [key, value] = variant.parameters.front();
    return key == "reading" ? value : "";
}

std::string place_in_run(const catalog::Check& check) {
    if (check.kind != catalog::CheckKind::parity) return {};
    if (check.at_contact_times) return fmt::format("t = {:g} t_col", *check.at_contact_times);
    if (check.from || check.to) {
        return fmt::format("t = {:g}-{}", check.from.value_or(0),
                           check.to ? fmt::format("{:g}", *check.to) : "end");
    }
    return {};
}

/// With all that the check itself says; its outcome is still open.
compare::Verdict blank_verdict(const catalog::Case& the_case, const catalog::Check& check,
                               const Place& place, const Codes& codes) {
    compare::Verdict verdict{.code = codes.code,
                             .observable = check.observable,
                             .column = check.column,
                             .aspect = aspect_of(check.aspect),
                             .along = check.along,
                             .kind = kind_of(check.kind),
                             .against = against_of(check),
                             .variant = place.name,
                             .limit = limit_of(check, codes),
                             .limit_reason = check.reason};
    if (!codes.other.empty()) verdict.against.name = codes.other;
    if (!is_fitted(the_case, check.observable)) {
        verdict.rule_variant = rule_variant_of(the_case.variants[place.variants.front()]);
    }
    return verdict;
}

void answer(Question& question) {
    const auto& check = question.check;
    const Operands operands = operands_of(question);
    const auto& missing = operands.missing;
    // A code without a run has no place in it.
    if (!missing || missing->code.empty()) question.verdict.place = place_in_run(check);
    if (missing) {
        question.verdict.absent_code = missing->code;
        return set_outcome(question, missing->outcome, missing->reason);
    }
    if (check.kind == catalog::CheckKind::parity) return judge_parity(question, operands.points);
    if (catalog::is_trend(check.aspect)) return judge_trend(question, operands.points);
    const bool value = check.aspect == catalog::Aspect::value;
    const bool on_ladder = check.kind == catalog::CheckKind::exact && !value;
    return on_ladder ? judge_convergence(question, operands.points)
                     : judge_equivalence(question, operands.points);
}

}  // namespace

std::vector<Question> answer_check(const CaseRuns& runs, const catalog::Check& check,
                                   const published::PublishedValues& literature,
                                   const Evaluation& evaluation) {
    std::vector<Question> questions;
    for (const Place& place : places_of(runs.the_case(), check)) {
        for (const Codes& codes : codes_of(runs, check, against_of(check).kind)) {
            questions.push_back({.runs = runs,
                                 .check = check,
                                 .literature = literature,
                                 .evaluation = evaluation,
                                 .other = codes.other,
                                 .variants = place.variants,
                                 .verdict = blank_verdict(runs.the_case(), check, place, codes),
                                 .curve = {}});
            answer(questions.back());
        }
    }
    if (check.kind == catalog::CheckKind::parity) doubt_identical(questions);
    return questions;
}

void set_outcome(Question& question, Outcome outcome, const std::string& reason) {
    const CaseRuns& runs = question.runs;
    const catalog::Check& check = question.check;
    compare::Verdict& verdict = question.verdict;
    const std::size_t variant = question.variants.front();
    std::string wanted = check.expect;
    for (const auto& code : {verdict.code, question.other}) {
        if (const auto found = check.expect_for.find(code); found != check.expect_for.end()) {
            wanted = found->second;
        }
    }
    for (const auto& [pattern, outcome_there] : check.expect_in) {
        if (is_fitted(runs.the_case(), check.observable)) break;  // belongs to no variant
        if (catalog::matches(pattern, runs.the_case().variants[variant].name)) {
            wanted = outcome_there;
        }
    }
    const bool known_gap =
        outcome == Outcome::not_expressible &&
        (runs.known_not_expressible(verdict.code, variant) ||
         (!question.other.empty() && runs.known_not_expressible(question.other, variant)));
    verdict.outcome = outcome;
    verdict.expected = known_gap || compare::to_string(outcome) == wanted;
    verdict.reason = reason;
    if (outcome != Outcome::agree && verdict.expected && !check.expect_reason.empty()) {
        verdict.reason += (reason.empty() ? "" : "; ") + ("expected: " + check.expect_reason);
    }
    if (outcome == Outcome::agree && !verdict.expected) {
        verdict.reason = "agrees although the catalogue records '" + wanted + "' (" +
                         check.expect_reason + "): update the catalogue";
    }
}

}  // namespace crossgrain::judge
