// Collision plans that become code: the plan of a table is worked out by the compiler, and every
// word of it then lives in a register. A table read at run time whose plan is one of these, up to
// the values of its probabilities, runs as code; any other one is interpreted, with the same bits.
#pragma once

#include "native/lga/collision_plan.hpp"
#include "native/lga/collision_trees.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace crossgrain::lga {

/// A plan without its memory: sizes are part of the type.
template <std::size_t configuration_count, std::size_t decision_count, std::size_t mask_count>
struct CompiledPlan {
    struct Asking {
        Stage stage = 0;
        std::uint64_t with_rest = 0, without_rest = 0, either = 0;  ///< bit c: configuration c
        friend constexpr bool operator==(const Asking&, const Asking&) = default;
    };
    std::array<PlannedConfiguration, configuration_count> configurations{};
    std::array<Asking, decision_count> decisions{};
    std::array<PlannedMask, mask_count> masks{};

    static constexpr int first_computed = first_decision_mask + static_cast<int>(decision_count);

    constexpr explicit CompiledPlan(const CollisionPlan& plan) {
        std::ranges::copy(plan.configurations, configurations.begin());
        std::ranges::copy(plan.masks, masks.begin());
        std::ranges::transform(plan.decisions, decisions.begin(), asking);
    }

    /// Whether the plan differs at most in the values of its probabilities.
    [[nodiscard]] bool matches(const CollisionPlan& plan) const {
        return std::ranges::equal(plan.configurations, configurations) &&
               std::ranges::equal(plan.masks, masks) &&
               std::ranges::equal(plan.decisions, decisions, {}, asking);
    }

  private:
    static constexpr Asking asking(const PlannedDecision& d) {
        const auto bits = [](const std::vector<int>& list) {
            std::uint64_t set = 0;
            for (const int c : list)
                set |= std::uint64_t{1} << c;
            return set;
        };
        return {.stage = d.stage,
                .with_rest = bits(d.with_rest),
                .without_rest = bits(d.without_rest),
                .either = bits(d.either)};
    }
};

/// Rows of the shipped tables, with some probability p: its value is not part of a plan.
namespace compiled_rows {

struct Row {
    SiteState before, after;
    double probability = 0;
    Matching matching = Matching::exact;
};

inline constexpr double p = 0.8;

/// The directions i + offsets.
constexpr SiteState site(int i, std::initializer_list<int> offsets, std::uint8_t rests = 0) {
    unsigned movers = 0;
    for (const int offset : offsets)
        movers |= 1U << ((i + offset + directions) % directions);
    return {.movers = static_cast<std::uint8_t>(movers), .rests = rests};
}

/// Two head on and three at 120 degrees, with and without a rest particle: reading std.
constexpr std::vector<Row> head_on_and_triples() {
    std::vector<Row> rows;
    for (int i = 0; i < 3; ++i) {
        rows.push_back({site(i, {0, 3}), site(i, {1, 4}), (1 - p) / 2});
        rows.push_back({site(i, {0, 3}), site(i, {2, 5}), (1 - p) / 2});
        rows.push_back({site(i, {0, 3}), site(i, {}, 2), p});
        rows.push_back({site(i, {0, 3}, 1), site(i, {}, 3), 1});
    }
    for (int i = 0; i < 2; ++i) {
        rows.push_back({site(i, {0, 2, 4}), site(i, {1, 3, 5}), 1 - p});
        rows.push_back({site(i, {0, 2, 4}), site(i, {}, 3), p});
        rows.push_back({site(i, {0, 2, 4}, 1), site(i, {}, 4), 1});
    }
    return rows;
}

/// Two at 120 degrees as well: readings P and D.
constexpr std::vector<Row> with_two_at_120_degrees() {
    auto rows = head_on_and_triples();
    for (int i = 0; i < directions; ++i) {
        rows.push_back({site(i, {0, 2}), site(i, {1}, 1), p});
    }
    return rows;
}

/// With spectators, and rests that take part: reading M.
constexpr std::vector<Row> with_spectators() {
    auto rows = head_on_and_triples();
    for (auto& row : rows) {
        if (std::popcount(row.before.movers) == 2) row.matching = Matching::spectators;
    }
    for (int i = 0; i < directions; ++i) {
        rows.push_back({site(i, {0, 2}, 1), site(i, {1}, 2), 1, Matching::spectators});
        rows.push_back({site(i, {0}, 1), site(i, {-1, 1}), 0.1});
    }
    return rows;
}

constexpr CollisionPlan plan_of(const std::vector<Row>& rows, Relocation relocation) {
    const auto collisions = collisions_of(rows);
    return plan(TableBuilder(collisions, relocation).build(), relocation);
}

struct Sizes {
    std::size_t configurations, decisions, masks;
};

/// `make()` gives a CollisionPlan.
template <class Make>
constexpr auto compiled(const Make& make) {
    constexpr Sizes sizes = [] {
        const CollisionPlan plan = Make()();
        return Sizes{plan.configurations.size(), plan.decisions.size(), plan.masks.size()};
    }();
    return CompiledPlan<sizes.configurations, sizes.decisions, sizes.masks>(make());
}

}  // namespace compiled_rows

}  // namespace crossgrain::lga
