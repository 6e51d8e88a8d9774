#include "native/hopper/plain_engine.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace crossgrain::hopper {
namespace {

/// (dk, dc) of the nodes 1..7 of the local numbering.
constexpr std::array<std::array<std::int32_t, 2>, 8> steps{
    {{0, 0}, {0, 0}, {1, -1}, {2, 0}, {1, 1}, {-1, 1}, {-2, 0}, {-1, -1}}};

constexpr std::array<std::int32_t, 2> step(int node) {
    return steps[static_cast<std::size_t>(node)];
}

}  // namespace

PlainEngine::PlainEngine(const Parameters& parameters)
    : parameters_(parameters), energies_(integer_energies(parameters.rules)), numbers_(parameters),
      filling_(parameters) {
    const int height = parameters.rows == Rows::zigzag ? 2 : 1;
    for (std::int32_t k = 0; k < parameters.levels; ++k) {
        if (k % height == 0) rows_.emplace_back();
        const Level& level = geometry().levels()[static_cast<std::size_t>(k)];
        auto number = static_cast<std::uint32_t>(level.offset);
        for (std::int32_t c = level.first; c <= level.last; c += 2) {
            rows_.back().push_back({.k = k, .c = c, .number = number++});
        }
    }
    if (parameters.sweep == Sweep::top_to_bottom) std::reverse(rows_.begin(), rows_.end());
}

void PlainEngine::advance(std::int64_t iterations) {
    for (std::int64_t i = 0; i < iterations; ++i)
        iterate();
}

void PlainEngine::iterate() {
    filling_.empty_outlet();
    for (const Row& row : rows_) {
        shuffle(row);
        for (const std::uint64_t visit : order_) {
            const Site& site = row[visit & 0xffffffffU];
            if (filling_.field[geometry().place(site.k, site.c)] == 0) fill(site);
        }
    }
    ++filling_.record.iterations;
}

void PlainEngine::shuffle(const Row& row) {
    const auto iteration = static_cast<std::uint32_t>(record().iterations);
    order_.resize(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
        const std::uint32_t order = parameters_.random == RandomSource::per_site
                                        ? numbers_.of_move(iteration, row[i].number).order
                                        : numbers_.of_stream(stream_place_++);
        order_[i] = std::uint64_t{order} << 32 | i;
    }
    std::sort(order_.begin(), order_.end());
}

Cell PlainEngine::cell_around(const Site& site) const {
    Cell cell{};
    for (int node = 1; node <= 7; ++node) {
        const auto [dk, dc] = step(node);
        cell[static_cast<std::size_t>(node)] =
            filling_.field[geometry().place(site.k + dk, site.c + dc)];
    }
    return cell;
}

void PlainEngine::fill(const Site& hole) {
    const Cell iloc = cell_around(hole);
    std::vector<Candidate> candidates;
    for (int i = 2; i <= 4; ++i) {
        const std::uint8_t s = iloc[static_cast<std::size_t>(i)];
        if (!occupied(s)) continue;
        for (int o = 1; o <= 3; ++o) {
            if (energies_.rotation || o == s) candidates.push_back({i, o});
        }
    }
    if (candidates.empty()) return;

    const Candidate move = choose_move(hole, iloc, candidates);
    const auto [dk, dc] = step(move.source);
    filling_.field[geometry().place(hole.k, hole.c)] = static_cast<std::uint8_t>(move.orientation);
    filling_.field[geometry().place(hole.k + dk, hole.c + dc)] = 0;
    note_vacated(hole.k + dk, hole.c + dc);
    ++filling_.record.moves;
}

Candidate PlainEngine::choose_move(const Site& hole, const Cell& iloc,
                                   const std::vector<Candidate>& candidates) {
    Energy lowest = std::numeric_limits<Energy>::max();
    for (const Candidate& candidate : candidates) {
        lowest = std::min(lowest, total_energy(iloc, candidate, energies_));
    }
    std::vector<Candidate> best;
    for (const Candidate& candidate : candidates) {
        if (total_energy(iloc, candidate, energies_) <= lowest + energies_.tie_tolerance) {
            best.push_back(candidate);
        }
    }
    if (best.size() == 1) return best.front();
    return best[choose(tie_number(hole), static_cast<std::uint32_t>(best.size()))];
}

std::uint32_t PlainEngine::tie_number(const Site& hole) {
    if (parameters_.random == RandomSource::shared_stream) {
        return numbers_.of_stream(stream_place_++);
    }
    return numbers_.of_move(static_cast<std::uint32_t>(record().iterations), hole.number).tie;
}

void PlainEngine::note_vacated(std::int32_t k, std::int32_t c) {
    const Level& level = geometry().levels()[static_cast<std::size_t>(k)];
    Record& record = filling_.record;
    if (c == level.first) record.left_reach = std::max(record.left_reach, k);
    if (c == level.last) record.right_reach = std::max(record.right_reach, k);
}

}  // namespace crossgrain::hopper
