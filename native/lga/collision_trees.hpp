// The trees of a collision table from its rows. All of it can run at compile time, which is how the
// shipped tables become code (compiled_plans.hpp).
#pragma once

#include "native/lga/collision_table.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace crossgrain::lga {

/// Rows with the same configuration.
struct Collision {
    SiteState before;
    Matching matching = Matching::exact;
    struct Row {
        SiteState after;
        double probability = 0;
    };
    std::vector<Row> rows;
};

/// Groups the rows, in an order that does not depend on theirs: configurations ascending; of their
/// rows those with most rests first, so that decisions of different configurations have the same
/// probability p.
template <class Rules>
[[nodiscard]] constexpr std::vector<Collision> collisions_of(const Rules& rules) {
    std::vector<Collision> collisions;
    for (const auto& rule : rules) {
        auto same = std::ranges::find(collisions, rule.before, &Collision::before);
        if (same == collisions.end()) {
            collisions.push_back({rule.before, rule.matching, {}});
            same = collisions.end() - 1;
        }
        same->rows.push_back({rule.after, rule.probability});
    }
    std::ranges::sort(collisions, [](const Collision& a, const Collision& b) {
        return std::pair(a.before.movers, a.before.rests) <
               std::pair(b.before.movers, b.before.rests);
    });
    for (auto& collision : collisions) {
        std::ranges::sort(collision.rows, [](const auto& a, const auto& b) {
            return std::pair(b.after.rests, a.after.movers) <
                   std::pair(a.after.rests, b.after.movers);
        });
    }
    return collisions;
}

/// Directions filled by `row` when it happens at a site with movers `site`; the spectators stay.
[[nodiscard]] constexpr bool is_free(const Collision& collision, const Collision::Row& row,
                                     std::uint8_t site) noexcept {
    const int spectators = site & ~collision.before.movers;
    return (spectators & row.after.movers) == 0;
}

[[nodiscard]] constexpr bool applies(const Collision& collision, std::uint8_t movers, int rests) {
    if (collision.before.rests != rests) return false;
    if (collision.matching == Matching::exact) return collision.before.movers == movers;
    if ((movers & collision.before.movers) != collision.before.movers) return false;
    return std::ranges::any_of(collision.rows,
                               [&](const auto& row) { return is_free(collision, row, movers); });
}

[[nodiscard]] constexpr std::uint8_t origins_of(std::uint8_t stopped) {
    std::uint8_t origins = 0;
    for (int i = 0; i < directions; ++i) {
        if ((stopped >> i) & 1) origins = static_cast<std::uint8_t>(origins | 1U << opposite(i));
    }
    return origins;
}

/// Builds the trees of a table; equal parts are shared.
class TableBuilder {
  public:
    constexpr TableBuilder(const std::vector<Collision>& collisions, Relocation relocation)
        : collisions_(collisions), relocation_(relocation) {}

    [[nodiscard]] constexpr CollisionTable build() {
        for (unsigned state = 0; state < site_states; ++state) {
            table_.roots[state] = root(static_cast<std::uint8_t>(state & 63U),
                                       static_cast<std::uint8_t>(state >> rest_bit));
        }
        return std::move(table_);
    }

  private:
    struct Option {
        double probability;
        Branch branch;
    };

    constexpr Branch outcome(const Outcome& wanted) {
        auto& all = table_.outcomes;
        const auto found = std::ranges::find(all, wanted);
        const auto index = static_cast<int>(found - all.begin());
        if (found == all.end()) all.push_back(wanted);
        return {.is_outcome = true, .index = index};
    }

    constexpr Branch decision(const Decision& wanted) {
        if (wanted.below >= certain || wanted.yes == wanted.no) return wanted.yes;
        if (wanted.below == 0) return wanted.no;
        auto& all = table_.decisions;
        const auto found = std::ranges::find(all, wanted);
        const auto index = static_cast<int>(found - all.begin());
        if (found == all.end()) all.push_back(wanted);
        return {.is_outcome = false, .index = index};
    }

    /// One of the options, or `otherwise` with what is missing from 1: each is asked in turn, with
    /// its probability under the condition that it was none before.
    constexpr Branch choice(const std::vector<Option>& options, const Branch& otherwise,
                            Stage first) {
        std::vector<std::uint32_t> below;
        double left = 1;
        for (const auto& option : options) {
            below.push_back(fixed_point(left > 0 ? std::min(option.probability / left, 1.0) : 0));
            left -= option.probability;
        }
        Branch branch = otherwise;
        for (std::size_t i = options.size(); i-- > 0;) {
            branch = decision({.stage = first + static_cast<Stage>(i),
                               .below = below[i],
                               .yes = options[i].branch,
                               .no = branch});
        }
        return branch;
    }

    constexpr Branch after_row(std::uint8_t movers, const Collision& collision,
                               const Collision::Row& row) {
        const auto after =
            static_cast<std::uint8_t>((movers & ~collision.before.movers) | row.after.movers);
        Outcome result{.movers = after, .rests = row.after.rests, .origins = 0};
        if (result.excess() == 0 || relocation_ == Relocation::random_walk) return outcome(result);
        const unsigned origins = origins_of(static_cast<std::uint8_t>(movers & ~after));
        std::vector<Option> sets;
        for (unsigned set = 0; set <= origins; ++set) {
            if ((set & ~origins) != 0 || std::popcount(set) != result.excess()) continue;
            result.origins = static_cast<std::uint8_t>(set);
            sets.push_back({.probability = 0, .branch = outcome(result)});
        }
        for (auto& set : sets)
            set.probability = 1.0 / static_cast<double>(sets.size());
        return choice(sets, sets.back().branch, first_origin_stage);
    }

    constexpr Branch after_collision(std::uint8_t movers, const Branch& unchanged,
                                     const Collision& collision) {
        std::vector<Option> rows;
        for (const auto& row : collision.rows) {
            const Branch branch =
                is_free(collision, row, movers) ? after_row(movers, collision, row) : unchanged;
            rows.push_back({.probability = row.probability, .branch = branch});
        }
        return choice(rows, unchanged, first_row_stage);
    }

    constexpr Branch root(std::uint8_t movers, std::uint8_t rests) {
        const Branch unchanged = outcome({.movers = movers, .rests = rests, .origins = 0});
        std::vector<Option> options;
        for (const auto& collision : collisions_) {
            if (!applies(collision, movers, rests)) continue;
            options.push_back(
                {.probability = 0, .branch = after_collision(movers, unchanged, collision)});
        }
        if (options.empty()) return unchanged;
        for (auto& option : options)
            option.probability = 1.0 / static_cast<double>(options.size());
        return choice(options, options.back().branch, first_collision_stage);
    }

    const std::vector<Collision>& collisions_;
    Relocation relocation_;
    CollisionTable table_;
};

}  // namespace crossgrain::lga
