// The certificate of equivalence: for every pair of codes, how far apart the same scene has drifted
// at each snapshot and in each window of the lid's height, and what the parity checks say of it.
#include "reference/judge/evaluate.hpp"

#include "reference/compare/parity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain::judge {
namespace {

using compare::Outcome;

bool certifies(const catalog::Check& check) {
    return check.kind == catalog::CheckKind::parity &&
           (check.at_contact_times || (check.from && check.to));
}

std::string window_name(const catalog::Check& check) {
    return fmt::format("{:g}-{:g}", *check.from, *check.to);
}

bool is_power_of_ten(double count) {
    const double exponent = std::log10(count);
    return std::abs(exponent - std::round(exponent)) < 1e-9;
}

/// The snapshots a case asks for, in contact times.
std::vector<double> snapshot_times(const catalog::Case& the_case) {
    for (const auto& request : the_case.observables) {
        const auto at = request.options.find("at_contact_times");
        if (request.name == "trajectory" && at != request.options.end()) return at->second.numbers;
    }
    return {};
}

void add_snapshots(const CaseRuns& runs, std::size_t variant, CertificatePair& pair) {
    const auto* a = runs.find(pair.a, variant, 0, 0);
    const auto* b = runs.find(pair.b, variant, 0, 0);
    if (a == nullptr || b == nullptr) return;
    for (const double count : snapshot_times(runs.the_case())) {
        const auto* in_a = compare::find_snapshot(a->results, count * pair.contact_time);
        const auto* in_b = compare::find_snapshot(b->results, count * pair.contact_time);
        if (in_a == nullptr || in_b == nullptr) continue;
        const auto difference = compare::largest_difference(*in_a, *in_b);
        if (!difference) continue;
        pair.curve_t.push_back(count * pair.contact_time);
        pair.curve_dx.push_back(*difference);
        if (is_power_of_ten(count)) pair.max_dx[fmt::format("{:g}", count)] = *difference;
    }
}

/// Worst first: a certificate is as good as its worst part.
int severity(Outcome outcome) {
    switch (outcome) {
    case Outcome::agree:
        return 0;
    case Outcome::not_expressible:
        return 1;
    case Outcome::not_installed:
        return 2;
    case Outcome::no_reference:
        return 3;
    case Outcome::undecided:
        return 4;
    case Outcome::run_failed:
        return 5;
    case Outcome::disagree:
        return 6;
    }
    return 6;
}

void add_check(const catalog::Check& check, const compare::Verdict& verdict,
               CertificatePair& pair) {
    if (check.at_contact_times) {
        pair.limits[fmt::format("{:g}", *check.at_contact_times)] = verdict.limit;
    } else {
        if (!std::isnan(verdict.difference)) pair.max_dh[window_name(check)] = verdict.difference;
        pair.limits_dh[window_name(check)] = verdict.limit;
    }
    pair.expected = pair.expected && verdict.expected;
    if (severity(verdict.outcome) >= severity(pair.outcome)) {
        pair.outcome = verdict.outcome;
        pair.reason = verdict.reason;
    }
}

/// What the certificate calls a variant: "gas-friction/granular".
std::string label(const catalog::Case& the_case, std::size_t variant) {
    const std::string& name = the_case.variants[variant].name;
    return name.empty() ? the_case.name : the_case.name + "/" + name;
}

CertificatePair certify(const CaseRuns& runs, const Evaluation& evaluation, std::size_t variant,
                        const std::string& a, const std::string& b) {
    const auto& the_case = runs.the_case();
    const auto scene = the_case.grain_scene(variant, 0, 1);
    CertificatePair pair{.case_name = label(the_case, variant),
                         .a = a,
                         .b = b,
                         .contact_time = scene::contact_time(scene),
                         .diameter = scene.grains.diameter,
                         .outcome = Outcome::agree};
    add_snapshots(runs, variant, pair);
    for (const auto& [check, index] : evaluation.parity) {
        const auto& verdict = evaluation.verdicts[index];
        if (certifies(*check) && verdict.code == a && verdict.against.name == b &&
            verdict.variant == the_case.variants[variant].name) {
            add_check(*check, verdict, pair);
        }
    }
    return pair;
}

/// Of a law in several variants those pairs are left out of which it is known that one of the two
/// does not have the variant.
bool is_known_gap(const CertificatePair& pair, const catalog::Case& the_case) {
    return the_case.variants.size() > 1 && pair.expected &&
           pair.outcome == Outcome::not_expressible;
}

}  // namespace

bool can_be_certified(const catalog::Case& the_case) {
    return std::ranges::any_of(the_case.checks, certifies);
}

void evaluate_certificate(const CaseRuns& runs, Evaluation& evaluation) {
    const auto& the_case = runs.the_case();
    if (!can_be_certified(the_case)) return;
    const auto& codes = runs.codes();
    for (std::size_t variant = 0; variant < the_case.variants.size(); ++variant) {
        for (std::size_t i = 0; i < codes.size(); ++i) {
            for (std::size_t j = i + 1; j < codes.size(); ++j) {
                auto pair = certify(runs, evaluation, variant, codes[i], codes[j]);
                if (!is_known_gap(pair, the_case))
                    evaluation.certificate.push_back(std::move(pair));
            }
        }
    }
}

}  // namespace crossgrain::judge
