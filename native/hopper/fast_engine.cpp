#include "native/hopper/fast_engine.hpp"

#include <algorithm>
#include <utility>

namespace crossgrain::hopper {

FastEngine::FastEngine(const Parameters& parameters, std::shared_ptr<const CandidateTable> table)
    : parameters_(parameters), numbers_(parameters), table_(std::move(table)),
      filling_(parameters) {
    const auto& levels = filling_.geometry.levels();
    // In a steady flow a level has fewer holes than the outlet has sites; one more is scratch.
    const auto capacity = static_cast<std::size_t>(parameters.outlet) + 1;
    lists_.resize(levels.size() + 2);
    for (std::size_t k = 0; k < lists_.size(); ++k) {
        lists_[k] = {.start = k * capacity, .capacity = capacity};
    }
    holes_.resize(lists_.size() * capacity + order_padding);
    std::size_t largest = 0;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const auto first = static_cast<std::uint32_t>(filling_.geometry.place_of_level(k));
        lists_[k].first_place = first;
        lists_[k].last_place = static_cast<std::uint32_t>(first + levels[k].sites() - 1);
        lists_[k].site_of_place = static_cast<std::uint32_t>(levels[k].offset) - first;
        largest = std::max(largest, levels[k].sites());
    }
    for (auto* numbers : {&order_, &tie_, &rank_, &arrivals_}) {
        numbers->resize(largest + order_padding);
    }
    plans_.resize(largest);
}

void FastEngine::advance(std::int64_t iterations) {
    for (std::int64_t i = 0; i < iterations; ++i) {
        begin_iteration();
        for (std::size_t n = 0; n < filling_.geometry.levels().size(); ++n)
            visit_level(n);
        end_iteration();
    }
}

void FastEngine::begin_iteration() {
    HoleList& list = lists_[0];
    make_room(list, filling_.geometry.levels()[0].sites());
    for (std::size_t i = 0; i < filling_.geometry.levels()[0].sites(); ++i) {
        const auto place = static_cast<std::uint32_t>(list.first_place + i);
        if (filling_.field[place] != 0) holes_[list.start + list.count++] = place;
    }
    filling_.empty_outlet();
    iteration_numbers_ = {numbers_, static_cast<std::uint32_t>(record().iterations)};
}

void FastEngine::visit_level(std::size_t n) {
    const auto& levels = filling_.geometry.levels();
    const std::size_t k = parameters_.sweep == Sweep::bottom_to_top ? n : levels.size() - 1 - n;
    const std::size_t count = std::exchange(lists_[k].count, 0);
    if (parameters_.random == RandomSource::shared_stream) {
        fill_by_stream(k, count);
    } else if (count != 0) {
        fill_by_site_numbers(k, count);
    }
    if (count == 0) return;
    for (std::size_t above = k + 1; above < std::min(k + 3, levels.size()); ++above) {
        note_reach(above);
    }
}

void FastEngine::note_reach(std::size_t k) {
    const HoleList& list = lists_[k];
    if (filling_.field[list.first_place] == 0 || filling_.field[list.last_place] == 0) {
        filling_.note_reach(k);
    }
}

void FastEngine::fill_by_site_numbers(std::size_t k, std::size_t count) {
    const HoleList& list = lists_[k];
    const std::uint32_t* const places = holes_.data() + list.start;
    const LevelNumbers numbers{.order = order_.data(), .tie = tie_.data(), .rank = rank_.data()};
    number_holes({.place = places, .count = count}, iteration_numbers_, list.site_of_place,
                 numbers);
    const Sight sight(*this);
    Plan* const plans = plans_.data();
    for (std::size_t i = 0; i < count; ++i) {
        plans[numbers.rank[i]] = sight.plan(places[i], numbers.tie[i]);
    }
    carry_out(k, count);
}

void FastEngine::fill_by_stream(std::size_t k, std::size_t count) {
    const HoleList& list = lists_[k];
    std::vector<std::pair<std::uint32_t, std::uint32_t>> holes(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t place = holes_[list.start + i];
        holes[i] = {numbers_.of_stream(stream_place_ + (place - list.first_place)), place};
    }
    std::sort(holes.begin(), holes.end());
    stream_place_ += filling_.geometry.levels()[k].sites();  // each site takes one for the order
    const Sight sight(*this);
    for (const auto& [order, place] : holes) {
        const auto list_of = candidate_lists[sight.entry(place) & CandidateTable::candidates];
        const bool tied = (list_of & 15) > 1;
        plans_[0] = sight.plan(place, tied ? numbers_.of_stream(stream_place_++) : 0);
        carry_out(k, 1);
    }
}

FastEngine::Sight::Sight(FastEngine& engine)
    : field(engine.filling_.field.data()), entries(engine.table_->entries()),
      to_2(engine.geometry().step(2)), to_3(engine.geometry().step(3)) {}

inline std::uint16_t FastEngine::Sight::entry(std::uint32_t place) const {
    const std::uint8_t* const hole = field + place;
    return entries[CandidateTable::index(hole[to_2], hole[to_3], hole[to_2 + 1], hole[-to_2],
                                         hole[-to_3], hole[-to_2 - 1])];
}

inline std::uint32_t FastEngine::Sight::shared_sources(std::uint32_t place) const {
    const std::uint8_t* const n2 = field + place + to_2;
    return n2[0] + 8U * n2[1];
}

inline FastEngine::Plan FastEngine::Sight::plan(std::uint32_t place, std::uint32_t tie) const {
    const std::uint16_t seen = entry(place);
    const std::uint64_t list = candidate_lists[seen & CandidateTable::candidates];
    const std::uint64_t chosen = tie * (list & 15) >> 32;
    const auto move = static_cast<std::uint32_t>(list >> (4 * chosen + 4) & 15);
    const std::uint32_t source = move >> 2;  // 0, 1, 2 for the nodes 2, 3, 4
    // No branch, which would be guessed wrong every third time: to_2, to_3 or to_2 + 1.
    const auto middle = static_cast<std::ptrdiff_t>(source & 1);
    const std::ptrdiff_t step = to_2 + (source >> 1) + (-middle & (to_3 - to_2));
    const std::uint32_t below = std::uint32_t{seen} >> candidate_count;
    return {.place = place,
            .source = static_cast<std::uint32_t>(place + step),
            .tie = tie,
            .bits = shared_sources(place) | (move & 7) << Plan::orientation_shift |
                    below << Plan::hole_below_shift};
}

void FastEngine::carry_out(std::size_t k, std::size_t count) {
    const Sight sight(*this);
    const Plan* const plans = plans_.data();
    HoleList& one = lists_[k + 1];
    HoleList& two = lists_[k + 2];
    make_room(one, count + 1);
    make_room(two, count + 1);
    std::uint32_t* one_up = holes_.data() + one.start + one.count;
    std::uint32_t* two_up = holes_.data() + two.start + two.count;
    std::uint32_t* arrival = arrivals_.data();
    const std::uint32_t* const one_start = one_up;
    const std::uint32_t* const two_start = two_up;

    for (std::size_t i = 0; i < count; ++i) {
        Plan p = plans[i];
        // A hole beside it may have taken a grain in the meantime.
        if (sight.shared_sources(p.place) != (p.bits & Plan::shared)) [[unlikely]] {
            p = sight.plan(p.place, p.tie);
        }
        if ((p.bits & Plan::orientation) == 0) [[unlikely]]
            continue;
        sight.field[p.place] = p.bits >> Plan::orientation_shift & 3;
        sight.field[p.source] = 0;
        // Written to both lists, kept in one: no branch.
        *one_up = *two_up = p.source;
        const std::uint32_t from_3 = p.bits >> Plan::from_3_shift & 1;
        one_up += 1 - from_3;
        two_up += from_3;
        *arrival = p.place;
        arrival += p.bits >> Plan::hole_below_shift;
    }
    const auto ones = static_cast<std::size_t>(one_up - one_start);
    const auto twos = static_cast<std::size_t>(two_up - two_start);
    one.count += ones;
    two.count += twos;
    filling_.record.moves += static_cast<std::int64_t>(ones + twos);
    for (const std::uint32_t* place = arrivals_.data(); place != arrival; ++place) {
        look_below(k, *place);
    }
}

void FastEngine::make_room(HoleList& list, std::size_t more) {
    if (list.count + more <= list.capacity) return;
    const std::size_t start = holes_.size() - order_padding;
    list.capacity = 2 * (list.count + more);
    holes_.resize(start + list.capacity + order_padding);
    std::copy_n(holes_.begin() + static_cast<std::ptrdiff_t>(list.start), list.count,
                holes_.begin() + static_cast<std::ptrdiff_t>(start));
    list.start = start;
}

void FastEngine::look_below(std::size_t k, std::uint32_t place) {
    const auto level = static_cast<std::ptrdiff_t>(k);
    const auto at = [&](int node) {
        return static_cast<std::uint32_t>(place + filling_.geometry.step(node));
    };
    await(level - 1, at(5));
    await(level - 2, at(6));
    await(level - 1, at(7));
}

void FastEngine::await(std::ptrdiff_t k, std::uint32_t place) {
    if (k < 0 || filling_.field[place] != 0) return;
    HoleList& list = lists_[static_cast<std::size_t>(k)];
    const auto start = holes_.begin() + static_cast<std::ptrdiff_t>(list.start);
    const auto end = start + static_cast<std::ptrdiff_t>(list.count);
    if (std::find(start, end, place) != end) return;
    make_room(list, 1);
    holes_[list.start + list.count++] = place;
}

}  // namespace crossgrain::hopper
