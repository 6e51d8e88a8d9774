#include "native/lga/collision_table.hpp"

#include "native/base/errors.hpp"
#include "native/lga/collision_trees.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace crossgrain::lga {
namespace {

constexpr std::size_t max_rows = first_origin_stage - first_row_stage;

[[noreturn]] void refuse(const Rule& rule, std::string problem, std::string got,
                         std::string expected) {
    throw CaseError({.file = rule.origin,
                     .key = fmt::format("collision '{}' -> '{}'", to_string(rule.before),
                                        to_string(rule.after)),
                     .problem = std::move(problem),
                     .got = std::move(got),
                     .expected = std::move(expected),
                     .hint = {}});
}

void check(const Rule& rule) {
    const auto [before, after] = std::pair(rule.before, rule.after);
    if (before.rests > 1) {
        refuse(rule, "starts with too many particles at rest", std::to_string(before.rests),
               "at most one per site");
    }
    if (mass(before) != mass(after)) {
        refuse(rule, "does not conserve mass",
               fmt::format("{} particles before and {} after", mass(before), mass(after)),
               "the same number");
    }
    if (momentum(before.movers) != momentum(after.movers)) {
        const auto a = momentum(before.movers), b = momentum(after.movers);
        refuse(rule, "does not conserve momentum",
               fmt::format("({}, {}) before and ({}, {}) after, right and down in half steps",
                           a.right, a.down, b.right, b.down),
               "the same momentum");
    }
    if (!(rule.probability >= 0 && rule.probability <= 1)) {
        refuse(rule, "has a probability out of range", fmt::format("{:g}", rule.probability),
               "a number in [0, 1]");
    }
}

/// What rows with the same configuration must have together.
void check_together(const std::vector<Rule>& rules, const Rule& first) {
    double sum = 0;
    std::size_t rows = 0;
    for (const auto& rule : rules) {
        if (rule.before != first.before) continue;
        if (rule.matching != first.matching) {
            refuse(rule, "allows spectators in some rows only", "both", "the same in all rows");
        }
        sum += rule.probability;
        ++rows;
    }
    if (sum > 1 + 1e-12) {
        refuse(first, "has rows that together exceed 1", fmt::format("{:g}", sum), "at most 1");
    }
    if (rows > max_rows) {
        refuse(first, "has too many rows", std::to_string(rows),
               fmt::format("at most {}", max_rows));
    }
}

}  // namespace

std::string to_string(const SiteState& site) {
    std::string text;
    for (int i = 0; i < directions; ++i) {
        if ((site.movers >> i) & 1) text += fmt::format("{}{}", text.empty() ? "" : " ", i);
    }
    for (int i = 0; i < site.rests; ++i)
        text += text.empty() ? "R" : " R";
    return text.empty() ? "empty" : text;
}

CollisionTable compile(const Model& model) {
    for (const auto& rule : model.rules)
        check(rule);
    for (const auto& rule : model.rules)
        check_together(model.rules, rule);
    return TableBuilder(collisions_of(model.rules), model.relocation).build();
}

}  // namespace crossgrain::lga
