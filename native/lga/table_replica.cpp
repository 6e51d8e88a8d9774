#include "native/lga/table_replica.hpp"

#include "native/lga/initial_state.hpp"
#include "native/lga/relocation_limits.hpp"

#include <algorithm>
#include <array>

namespace crossgrain::lga {
namespace {

bool has(std::uint8_t site, int direction) {
    return ((site >> direction) & 1) != 0;
}

/// Moves a particle within its site, unless it is not there or the target is taken.
bool can_turn(std::uint8_t site, int from, int to) {
    return has(site, from) && !has(site, to);
}

std::uint8_t turned(std::uint8_t site, int from, int to) {
    return static_cast<std::uint8_t>(site ^ (1U << from) ^ (1U << to));
}

}  // namespace

TableReplica::TableReplica(const Model& model, int replica)
    : model_(model), geometry_(model), table_(compile(model)),
      keys_(model.seed, RandomUse::dynamics), gravity_(fixed_point(model.gravity)),
      roughness_(fixed_point(model.roughness)), injection_(fixed_point(model.injection)),
      block_(static_cast<std::uint32_t>(replica / block_bits)), word_(replica % block_bits / 64),
      bit_(replica % 64), sites_(initial_state(model, replica)), next_(sites_.size(), 0),
      excess_(sites_.size(), 0), arrivals_(sites_.size(), 0) {}

void TableReplica::advance() {
    collide();
    relocate();
    kick();
    if (!model_.periodic) inject();
    propagate();
    ++step_;
}

unsigned TableReplica::four_bits(Draw draw, int offset, int site) const {
    Counter first = counter(step_, static_cast<std::uint32_t>(site), block_);
    first.high += static_cast<std::uint32_t>(draw) + static_cast<std::uint32_t>(offset);
    const Blocks blocks = random_blocks(keys_, first);
    unsigned bits = 0;
    for (const auto& block : blocks) {
        bits =
            bits << 1 | static_cast<unsigned>(block[static_cast<std::size_t>(word_)] >> bit_ & 1);
    }
    return bits;
}

bool TableReplica::decide(std::uint32_t value, Draw draw, int offset, int site) const {
    if (value == 0 || value >= certain) return value != 0;
    for (int known = 0; known < probability_bits; known += 4) {
        const unsigned u = four_bits(draw, offset + known, site);
        const unsigned v = value >> (probability_bits - known - 4) & 15U;
        if (u != v) return u < v;
    }
    return false;  // u equals the value
}

const Outcome& TableReplica::outcome(std::uint8_t state, int site) const {
    Branch branch = table_.roots[state];
    while (!branch.is_outcome) {
        const auto& d = table_.decisions[static_cast<std::size_t>(branch.index)];
        branch = decide(d.below, Draw::collision, 32 * d.stage, site) ? d.yes : d.no;
    }
    return table_.outcomes[static_cast<std::size_t>(branch.index)];
}

void TableReplica::collide() {
    for (int column = 0; column < geometry_.columns(); ++column) {
        for (int row = 0; row < geometry_.rows(); ++row) {
            const Site site{.column = column, .row = row};
            if (geometry_.is_wall(column)) {
                reflect_at(site);
            } else {
                collide_at(site);
            }
        }
    }
}

void TableReplica::collide_at(Site site) {
    auto& state = at(site);
    if (state == 0) return;
    const int index = geometry_.index(site);
    const Outcome& after = outcome(state, index);
    state = static_cast<std::uint8_t>(after.movers | (after.rests > 0 ? 1U << rest_bit : 0U));
    if (after.origins != 0) {
        returns_.push_back({site, after.origins});
    } else if (after.excess() > 0) {
        excess_[static_cast<std::size_t>(index)] = static_cast<std::uint16_t>(after.excess());
        walkers_.push_back(index);
    }
}

/// Bounced back with probability b, else specular: on the left 4 -> 1 or 2 and 5 -> 2 or 1, on the
/// right the mirror image. If both arrive, both leave.
void TableReplica::reflect_at(Site site) {
    const bool left = site.column == 0;
    const int up = left ? 4 : 2;
    const int down = left ? 5 : 1;
    auto& state = at(site);
    const bool both = has(state, up) && has(state, down);
    std::uint8_t leaving = 0;
    for (const int arriving : {up, down}) {
        if (!has(state, arriving)) continue;
        // The vertical mirror image of the reversed direction.
        const int specular = arriving == up ? opposite(down) : opposite(up);
        const bool back = both || decide(roughness_, Draw::reflection, 0, geometry_.index(site));
        leaving = static_cast<std::uint8_t>(leaving | 1U << (back ? opposite(arriving) : specular));
    }
    state = leaving;
}

void TableReplica::relocate() {
    return_to_origins();
    for (std::int64_t round = 0; !walkers_.empty(); ++round) {
        if (round == saturation_round) {
            const auto at_rest = std::ranges::count_if(
                sites_, [](std::uint8_t state) { return has(state, rest_bit); });
            std::int64_t rests = at_rest;
            for (const int site : walkers_)
                rests += excess_[static_cast<std::size_t>(site)];
            saturated_ = rests > geometry_.interior_sites();
        }
        if (round == max_rounds(geometry_)) saturated_ = true;
        if (saturated_ || !hop(round)) break;
    }
    walkers_.clear();
}

/// In the order of sites, then of directions. Who finds the origin taken walks on from its site.
void TableReplica::return_to_origins() {
    for (const auto& [site, origins] : returns_) {
        const int index = geometry_.index(site);
        for (int i = 0; i < directions; ++i) {
            if (((origins >> i) & 1) == 0) continue;
            const int target = geometry_.interior_neighbour(site, i);
            if (target >= 0 && !has(sites_[static_cast<std::size_t>(target)], rest_bit)) {
                sites_[static_cast<std::size_t>(target)] |= 1U << rest_bit;
            } else if (excess_[static_cast<std::size_t>(index)]++ == 0) {
                walkers_.push_back(index);
            }
        }
    }
    returns_.clear();
}

/// One round, see relocation_limits.hpp. Returns whether any rests still walk.
bool TableReplica::hop(std::int64_t round) {
    std::vector<int> touched = walkers_;
    for (const int index : walkers_) {
        const int direction =
            static_cast<int>(four_bits(Draw::hop, static_cast<int>(3 * round), index) >> 1);
        const Site site{.column = index / geometry_.rows(), .row = index % geometry_.rows()};
        const int target =
            direction < directions ? geometry_.interior_neighbour(site, direction) : -1;
        if (target < 0) continue;
        --excess_[static_cast<std::size_t>(index)];
        ++arrivals_[static_cast<std::size_t>(target)];
        touched.push_back(target);
    }
    std::ranges::sort(touched);
    const auto repeated = std::ranges::unique(touched);
    touched.erase(repeated.begin(), repeated.end());
    walkers_.clear();
    for (const int index : touched) {
        const auto i = static_cast<std::size_t>(index);
        if (arrivals_[i] > 0 && !has(sites_[i], rest_bit)) {
            sites_[i] |= 1U << rest_bit;
            --arrivals_[i];
        }
        excess_[i] = static_cast<std::uint16_t>(excess_[i] + arrivals_[i]);
        arrivals_[i] = 0;
        if (excess_[i] > 0) walkers_.push_back(index);
    }
    return !walkers_.empty();
}

void TableReplica::kick() {
    for (int column = 0; column < geometry_.columns(); ++column) {
        if (geometry_.is_wall(column) && !model_.gravity_rule.on_walls) continue;
        for (int row = 0; row < geometry_.rows(); ++row)
            kick_at({.column = column, .row = row});
    }
}

/// Targets must be empty before the step: the two vertical kicks exclude each other.
void TableReplica::kick_at(Site site) {
    constexpr int rest = rest_bit;
    const int index = geometry_.index(site);
    const auto& rule = model_.gravity_rule;
    const auto state = at(site);
    auto kicked = state;
    if (rule.up_diagonals && can_turn(state, 2, 1) &&
        decide(gravity_, Draw::right_kick, 0, index)) {
        kicked = turned(kicked, 2, 1);
    }
    if (rule.up_diagonals && can_turn(state, 4, 5) && decide(gravity_, Draw::left_kick, 0, index)) {
        kicked = turned(kicked, 4, 5);
    }
    const bool falls = rule.rest_to_down && can_turn(state, rest, 0);
    const bool stops = rule.up_to_rest && can_turn(state, 3, rest);
    if ((falls || stops) && decide(gravity_, Draw::vertical_kick, 0, index)) {
        kicked = falls ? turned(kicked, rest, 0) : turned(kicked, 3, rest);
    }
    at(site) = kicked;
}

/// States of the top row that point into the pipe and come from outside, if empty, with
/// probability I: 0 in all interior columns, 1 and 5 in the columns that are half a site higher;
/// the downward diagonal of the wall sites.
void TableReplica::inject() {
    for (int column = 0; column < geometry_.columns(); ++column) {
        const Site site{.column = column, .row = 0};
        auto& state = at(site);
        for (const int i : {0, 1, 5}) {
            if (!geometry_.is_fed(column, i) || has(state, i)) continue;
            if (decide(injection_, Draw::injection, 32 * i, geometry_.index(site))) {
                state = static_cast<std::uint8_t>(state | 1U << i);
            }
        }
    }
}

void TableReplica::propagate() {
    std::ranges::fill(next_, std::uint8_t{0});
    for (int column = 0; column < geometry_.columns(); ++column) {
        for (int row = 0; row < geometry_.rows(); ++row) {
            const auto state = at({.column = column, .row = row});
            const auto here = static_cast<std::size_t>(geometry_.index({column, row}));
            next_[here] = static_cast<std::uint8_t>(next_[here] | (state & 1U << rest_bit));
            for (int i = 0; i < directions; ++i) {
                if (!has(state, i)) continue;
                const int to = geometry_.row_after(row, geometry_.row_step(i, column));
                if (to < 0) continue;  // left the open pipe
                const auto there = static_cast<std::size_t>(
                    geometry_.index({column + Geometry::column_step(i), to}));
                next_[there] = static_cast<std::uint8_t>(next_[there] | 1U << i);
            }
        }
    }
    sites_.swap(next_);
}

}  // namespace crossgrain::lga
