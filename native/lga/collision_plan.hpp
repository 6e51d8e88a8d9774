// The collision table as word logic, for the bit-sliced engine: which words of bits must be made,
// and which of them flips which state of which configuration.
//
// A configuration is a set of movers; its minterm is the word of the replicas that have it. Each
// output word is the XOR over configurations of (minterm AND mask), where a mask says in which
// replicas the output changes, as a function of the rest particle and of the decisions. Masks form
// one shared diagram: mask = variable ? mask : mask.
#pragma once

#include "native/lga/collision_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace crossgrain::lga {

/// Output words of a collision: flips of the six movers and of the rest particle, then what is
/// known of excess rests: with Relocation::origin_first whether one goes to each of the six
/// neighbours, with random_walk their number in three bits.
inline constexpr std::size_t flip_outputs = 7;
inline constexpr std::size_t excess_outputs = 6;
inline constexpr std::size_t outputs = flip_outputs + excess_outputs;

/// Masks that are given; all others are computed in their order.
inline constexpr int never_mask = 0;
inline constexpr int always_mask = 1;
inline constexpr int rest_mask = 2;  ///< a rest particle before the collision
inline constexpr int first_decision_mask = 3;

struct PlannedConfiguration {
    std::uint8_t even = 0;  ///< movers 0, 2, 4 as bits 0, 1, 2
    std::uint8_t odd = 0;   ///< movers 1, 3, 5
    bool has_excess = false;
    std::array<int, outputs> mask{};
    friend bool operator==(const PlannedConfiguration&, const PlannedConfiguration&) = default;
};

/// Which replicas ask for a decision: those in one of these configurations.
struct PlannedDecision {
    Stage stage = 0;
    std::uint32_t below = 0;
    std::vector<int> with_rest, without_rest, either;  ///< indices of configurations
};

struct PlannedMask {
    int variable = 0, yes = 0, no = 0;  ///< masks
    friend bool operator==(const PlannedMask&, const PlannedMask&) = default;
};

struct CollisionPlan {
    std::vector<PlannedConfiguration> configurations;  ///< those that can change
    std::vector<PlannedDecision> decisions;            ///< their masks follow first_decision_mask
    std::vector<PlannedMask> masks;                    ///< the computed ones

    [[nodiscard]] constexpr int first_computed_mask() const noexcept {
        return first_decision_mask + static_cast<int>(decisions.size());
    }
    [[nodiscard]] constexpr std::size_t mask_count() const noexcept {
        return static_cast<std::size_t>(first_computed_mask()) + masks.size();
    }
};

/// Makes the plan of a table; can run at compile time.
class Planner {
  public:
    constexpr Planner(const CollisionTable& table, Relocation relocation)
        : table_(table), relocation_(relocation) {}

    [[nodiscard]] constexpr CollisionPlan plan() {
        for (const auto& d : table_.decisions) {
            if (variable(d) < 0) plan_.decisions.push_back({.stage = d.stage, .below = d.below});
        }
        for (unsigned movers = 0; movers < 1U << directions; ++movers)
            add(movers);
        return std::move(plan_);
    }

  private:
    /// Mask of a decision, or -1.
    [[nodiscard]] constexpr int variable(const Decision& d) const {
        for (std::size_t k = 0; k < plan_.decisions.size(); ++k) {
            if (plan_.decisions[k].stage == d.stage && plan_.decisions[k].below == d.below) {
                return first_decision_mask + static_cast<int>(k);
            }
        }
        return -1;
    }

    constexpr int mask(const PlannedMask& wanted) {
        if (wanted.yes == wanted.no) return wanted.yes;
        if (wanted.yes == always_mask && wanted.no == never_mask) return wanted.variable;
        const auto found = std::ranges::find(plan_.masks, wanted);
        const auto index = static_cast<int>(found - plan_.masks.begin());
        if (found == plan_.masks.end()) plan_.masks.push_back(wanted);
        return plan_.first_computed_mask() + index;
    }

    /// Where `bit` of the outcome is set.
    template <class Bit>
    constexpr int mask_of(const Branch& branch, const Bit& bit) {
        if (branch.is_outcome) {
            const auto& outcome = table_.outcomes[static_cast<std::size_t>(branch.index)];
            return bit(outcome) ? always_mask : never_mask;
        }
        const auto& d = table_.decisions[static_cast<std::size_t>(branch.index)];
        const int yes = mask_of(d.yes, bit);
        const int no = mask_of(d.no, bit);
        return mask({.variable = variable(d), .yes = yes, .no = no});
    }

    /// Output `o` of an outcome from a site with these movers and rests.
    [[nodiscard]] constexpr bool output(std::size_t o, const Outcome& after, unsigned movers,
                                        unsigned rests) const {
        if (o < directions) return (((after.movers ^ movers) >> o) & 1U) != 0;
        if (o < flip_outputs) return (after.rests > 0) != (rests > 0);
        const auto k = o - flip_outputs;
        if (relocation_ == Relocation::origin_first) return ((after.origins >> k) & 1U) != 0;
        return k < 3 && ((after.excess() >> k) & 1) != 0;
    }

    constexpr void add(unsigned movers) {
        const std::array<Branch, 2> roots{table_.roots[movers],
                                          table_.roots[movers | 1U << rest_bit]};
        PlannedConfiguration c{
            .even = static_cast<std::uint8_t>((movers & 1U) | (movers >> 1U & 2U) |
                                              (movers >> 2U & 4U)),
            .odd = static_cast<std::uint8_t>((movers >> 1U & 1U) | (movers >> 2U & 2U) |
                                             (movers >> 3U & 4U))};
        bool changes = false;
        for (std::size_t o = 0; o < outputs; ++o) {
            std::array<int, 2> by_rest{};
            for (unsigned rests = 0; rests < 2; ++rests) {
                by_rest[rests] = mask_of(
                    roots[rests], [&](const Outcome& a) { return output(o, a, movers, rests); });
            }
            c.mask[o] = mask({.variable = rest_mask, .yes = by_rest[1], .no = by_rest[0]});
            changes = changes || c.mask[o] != never_mask;
            if (o >= flip_outputs && c.mask[o] != never_mask) c.has_excess = true;
        }
        if (!changes) return;
        const auto index = static_cast<int>(plan_.configurations.size());
        plan_.configurations.push_back(c);
        ask(index, roots);
    }

    constexpr void ask(int configuration, const std::array<Branch, 2>& roots) {
        for (std::size_t k = 0; k < plan_.decisions.size(); ++k) {
            auto& d = plan_.decisions[k];
            const bool without = asks(roots[0], d), with = asks(roots[1], d);
            if (without && with) d.either.push_back(configuration);
            if (without && !with) d.without_rest.push_back(configuration);
            if (with && !without) d.with_rest.push_back(configuration);
        }
    }

    [[nodiscard]] constexpr bool asks(const Branch& branch, const PlannedDecision& wanted) const {
        if (branch.is_outcome) return false;
        const auto& d = table_.decisions[static_cast<std::size_t>(branch.index)];
        return (d.stage == wanted.stage && d.below == wanted.below) || asks(d.yes, wanted) ||
               asks(d.no, wanted);
    }

    const CollisionTable& table_;
    Relocation relocation_;
    CollisionPlan plan_;
};

[[nodiscard]] constexpr CollisionPlan plan(const CollisionTable& table, Relocation relocation) {
    return Planner(table, relocation).plan();
}

}  // namespace crossgrain::lga
