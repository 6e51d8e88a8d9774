#include "tests/selftest/selftest_culprit.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace crossgrain::selftest {
namespace {

using compare::Kind;
using compare::Outcome;
using compare::Verdict;

bool same_question(const Verdict& a, const Verdict& b) {
    const auto key = [](const Verdict& v) {
        return std::tie(v.code, v.observable, v.column, v.aspect, v.along, v.kind, v.variant,
                        v.place);
    };
    return key(a) == key(b) && a.against == b.against;
}

/// Whether a failed run of its own, and not of the other one of a pair, is what is objected to.
bool blames(const Verdict& v, const std::string& code) {
    if (v.code != code && !(is_pair(v) && v.against.name == code)) return false;
    return v.outcome != Outcome::run_failed || !is_pair(v) || v.absent_code == code;
}

std::set<std::string> codes_in(const std::vector<Verdict>& verdicts) {
    std::set<std::string> codes;
    for (const auto& v : verdicts) {
        codes.insert(v.code);
        if (is_pair(v)) codes.insert(v.against.name);
    }
    return codes;
}

bool all_object_to_the_reference(const std::vector<Verdict>& objections,
                                 const std::vector<Verdict>& all) {
    std::set<std::string> objecting, asked;
    for (const auto& v : objections) {
        if (v.kind != Kind::published) return false;
        objecting.insert(v.code);
    }
    for (const auto& v : all) {
        if (v.kind == Kind::published) asked.insert(v.code);
    }
    const bool empty = std::ranges::all_of(
        objections, [](const auto& v) { return v.outcome == Outcome::no_reference; });
    return empty || (objecting.size() > 1 && objecting == asked);
}

/// Smaller is more telling.
int rank(const Verdict& v) {
    if (v.outcome == Outcome::run_failed) return 0;
    if (v.kind == Kind::exact) return 1;
    if (v.kind == Kind::published) return 2;
    return v.kind == Kind::agree ? 3 : 4;
}

}  // namespace

std::vector<Verdict> new_objections(const std::vector<Verdict>& before,
                                    const std::vector<Verdict>& now) {
    std::vector<Verdict> objections;
    for (const auto& v : now) {
        if (v.expected || v.outcome == Outcome::undecided) continue;
        const auto counterpart = std::ranges::find_if(
            before, [&](const auto& other) { return same_question(other, v); });
        if (counterpart == before.end() || counterpart->expected) objections.push_back(v);
    }
    return objections;
}

std::optional<std::string> culprit_of(const std::vector<Verdict>& objections,
                                      const std::vector<Verdict>& all) {
    if (objections.empty()) return std::nullopt;
    if (all_object_to_the_reference(objections, all)) return "published";
    std::optional<std::string> most;
    std::ptrdiff_t largest = 0;
    for (const auto& code : codes_in(all)) {
        const auto count =
            std::ranges::count_if(objections, [&](const auto& v) { return blames(v, code); });
        if (count > largest) {
            most = code;
            largest = count;
        } else if (count == largest) {
            most.reset();
        }
    }
    return most;
}

const Verdict& most_telling(const std::vector<Verdict>& objections,
                            const std::optional<std::string>& culprit) {
    return *std::ranges::min_element(objections, {}, [&](const auto& v) {
        const bool about = !culprit || *culprit == "published" || blames(v, *culprit);
        return std::pair(!about, rank(v));
    });
}

}  // namespace crossgrain::selftest
