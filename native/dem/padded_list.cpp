#include "native/dem/padded_list.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace crossgrain::dem {
namespace {

/// Grains that are sorted among each other by number of neighbours; a multiple of all lanes. More
/// would make groups more alike and their neighbours farther apart in memory.
constexpr std::size_t window = 256;

/// Of floats in the widest vector.
constexpr std::size_t most_lanes = 16;

/// More neighbours than this less one do not count when grains are sorted.
constexpr std::size_t most_ranked = 12;

Bounds bounds_of(std::span<const double> values, ThreadTeam& team) {
    std::vector<Bounds> parts(team.size(), {values.front(), values.front()});
    team.split(values.size(), 1, [&](std::size_t begin, std::size_t end, std::size_t thread) {
        Bounds part{values[begin], values[begin]};
        for (std::size_t i = begin; i < end; ++i) {
            part.low = std::min(part.low, values[i]);
            part.high = std::max(part.high, values[i]);
        }
        parts[thread] = part;
    });
    for (const Bounds& part : parts) {
        parts.front().low = std::min(parts.front().low, part.low);
        parts.front().high = std::max(parts.front().high, part.high);
    }
    return parts.front();
}

std::size_t cells_along(double length, double range, std::size_t most) {
    return static_cast<std::size_t>(std::clamp(length / range, 1.0, static_cast<double>(most)));
}

std::size_t cell_of(double offset, double per_length, std::size_t cells) {
    const double cell = offset * per_length;
    return cell > 0 ? std::min(static_cast<std::size_t>(cell), cells - 1) : 0;
}

}  // namespace

void PaddedListMaker::set_cells(std::span<const double> x, std::span<const double> y,
                                const PaddedListShape& shape, ThreadTeam& team) {
    const Bounds in_x = shape.period_x ? Bounds{0.0, *shape.period_x} : bounds_of(x, team);
    const Bounds in_y = heights_ = bounds_of(y, team);
    const double range = shape.diameter + shape.skin;
    const double height = std::max(in_y.high - in_y.low, range);
    const double width = std::max(in_x.high - in_x.low, range);
    low_x_ = in_x.low;
    // A dilute system gets fewer, larger cells.
    const std::size_t most = 4 * x.size() + 64;
    // Rounding of positions as floats must not cost a pair, nor put one out of the next cell.
    const double slack = 1e-6 * (height + 4 * range);
    cells_.rows = cells_along(height, range + slack, most / 8);
    cells_.columns =
        cells_along(width, range + slack, std::max<std::size_t>(most / cells_.rows, 4));
    per_height_ = static_cast<double>(cells_.rows) / height;
    per_width_ = static_cast<double>(cells_.columns) / width;
    cells_.column_width = static_cast<float>(1 / per_width_);
    cells_.periodic = shape.period_x.has_value();
    const double listed = range + slack;
    // What is as near as this is likely to touch before the list is used up.
    const double near = shape.diameter + shape.skin / 4;
    cells_.near_squared = static_cast<float>(near * near);
    cells_.range_squared = static_cast<float>(listed * listed);
}

void PaddedListMaker::sort_by_cell(std::span<const double> x, std::span<const double> y,
                                   const PaddedListShape& shape, ThreadTeam& team) {
    set_cells(x, y, shape, team);
    const std::size_t grains = x.size();
    std::vector<std::uint32_t> cell(grains);
    team.split(grains, 1, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i) {
            cell[i] = static_cast<std::uint32_t>(
                cell_of(x[i] - low_x_, per_width_, cells_.columns) * cells_.rows +
                cell_of(y[i] - heights_.low, per_height_, cells_.rows));
        }
    });
    cells_.start.assign(cells_.columns * cells_.rows + 1, 0);
    for (const std::uint32_t c : cell)
        ++cells_.start[c + 1];
    for (std::size_t c = 1; c < cells_.start.size(); ++c)
        cells_.start[c] += cells_.start[c - 1];
    std::vector<std::uint32_t> next(cells_.start.begin(), cells_.start.end() - 1);
    by_cell_.resize(grains);
    for (std::size_t i = 0; i < grains; ++i)
        by_cell_[next[cell[i]]++] = static_cast<std::uint32_t>(i);
    cells_.cell.resize(grains);
    cells_.x.resize(grains + CellView::padding);
    cells_.y.resize(grains + CellView::padding);
    team.split(grains, 1, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t place = begin; place < end; ++place) {
            const std::uint32_t i = by_cell_[place];
            cells_.cell[place] = cell[i];
            const std::size_t column = cell[i] / cells_.rows;
            const double left = low_x_ + static_cast<double>(column) / per_width_;
            cells_.x[place] = static_cast<float>(x[i] - left);
            cells_.y[place] = static_cast<float>(y[i] - heights_.low);
        }
    });
}

void PaddedListMaker::find(Part& part) {
    const std::size_t first = part.first_window * window;
    const std::size_t last = std::min(part.last_window * window, by_cell_.size());
    part.found.crowded = false;
    find_neighbours_function()(cells_, first, last, part.found);
    if (part.found.crowded) return;
    std::size_t next = 0;
    for (std::size_t i = first; i < last; ++i) {
        first_neighbour_[i] = next;
        next += part.found.counts[i - first];
    }
}

/// Most near neighbours first, then most neighbours, equal numbers as they were: a counting sort of
/// each window.
void PaddedListMaker::sort_windows(Part& part) {
    const std::size_t offset = part.first_window * window;
    const std::size_t end = std::min(part.last_window * window, by_cell_.size());
    for (std::size_t first = offset; first < end; first += window) {
        const std::size_t last = std::min(first + window, end);
        std::array<std::uint32_t, most_ranked * most_ranked + 1> starts{};
        const auto rank = [&](std::size_t i) {
            const auto near =
                std::min<std::size_t>(part.found.near_counts[i - offset], most_ranked - 1);
            const auto all = std::min<std::size_t>(part.found.counts[i - offset], most_ranked - 1);
            return (most_ranked - 1 - near) * most_ranked + most_ranked - 1 - all;
        };
        for (std::size_t i = first; i < last; ++i)
            ++starts[rank(i) + 1];
        for (std::size_t r = 1; r < starts.size(); ++r)
            starts[r] += starts[r - 1];
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t place = first + starts[rank(i)]++;
            from_[place] = static_cast<std::uint32_t>(i);
            place_[i] = static_cast<std::uint32_t>(place);
            order_[place] = by_cell_[i];
        }
    }
}

void PaddedListMaker::write_rows(Part& part, const PaddedListShape& shape, PaddedList& list) const {
    const std::size_t lanes = shape.group.lanes;
    const std::size_t grains = by_cell_.size();
    const std::size_t groups = (grains + lanes - 1) / lanes;
    const std::size_t offset = part.first_window * window;
    const auto size = static_cast<std::uint32_t>(shape.record_size);
    const auto dummy = static_cast<std::uint32_t>(groups * lanes) * size;
    part.rows.clear();
    part.offsets.clear();
    std::array<std::size_t, most_lanes> place_of_lane{};
    for (std::size_t lane = 0; lane < lanes; ++lane)
        place_of_lane[lane] = shape.group.place_of_lane(lane);
    std::array<std::uint32_t, most_lanes> grain{};
    const std::size_t last_group = std::min(part.last_window * window / lanes, groups);
    for (std::size_t group = offset / lanes; group < last_group; ++group) {
        std::uint32_t rows = 0;
        std::uint8_t crosses = 0;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            // Lanes beyond the last grain repeat it.
            grain[lane] = from_[std::min(group * lanes + place_of_lane[lane], grains - 1)];
            rows = std::max(rows, part.found.counts[grain[lane] - offset]);
            crosses |= part.found.crosses[grain[lane] - offset];
        }
        const std::size_t base = part.offsets.size();
        part.offsets.resize(base + rows * lanes, dummy);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::uint32_t i = grain[lane];
            const auto* neighbours = part.found.neighbours.data() + first_neighbour_[i];
            const std::size_t count = part.found.counts[i - offset];
            auto* offsets = part.offsets.data() + base + lane;
            for (std::size_t row = 0; row < count; ++row)
                offsets[row * lanes] = place_[neighbours[row]] * size;
        }
        part.rows.push_back(rows);
        list.crosses[group] = crosses;
    }
}

void PaddedListMaker::join(const PaddedListShape& shape, ThreadTeam& team, PaddedList& list) {
    std::size_t group = 0;
    list.first_row.assign(list.crosses.size() + 1, 0);
    for (const Part& part : parts_) {
        for (const std::uint32_t rows : part.rows) {
            list.first_row[group + 1] = list.first_row[group] + rows;
            ++group;
        }
    }
    list.offsets.resize(list.first_row.back() * shape.group.lanes);
    // Due at once, until they are ordered.
    list.due.assign(list.first_row.back() + list.crosses.size(), 0);
    for (std::size_t ended = 0; ended < list.crosses.size(); ++ended)
        list.due[list.first_row[ended + 1] + ended] = std::numeric_limits<float>::infinity();
    team.run([&](std::size_t thread) {
        const Part& part = parts_[thread];
        const std::size_t first_group =
            std::min(part.first_window * window / shape.group.lanes, list.crosses.size());
        std::copy(part.offsets.begin(), part.offsets.end(),
                  list.offsets.begin() +
                      static_cast<std::ptrdiff_t>(list.first_row[first_group] * shape.group.lanes));
    });
}

const std::vector<std::uint32_t>& PaddedListMaker::make(std::span<const double> x,
                                                        std::span<const double> y,
                                                        const PaddedListShape& shape,
                                                        ThreadTeam& team, PaddedList& list) {
    sort_by_cell(x, y, shape, team);
    for (auto* values : {&from_, &place_, &order_})
        values->resize(x.size());
    first_neighbour_.resize(x.size());
    list.crosses.resize((x.size() + shape.group.lanes - 1) / shape.group.lanes);
    const std::size_t windows = (x.size() + window - 1) / window;
    parts_.resize(team.size());
    team.run([&](std::size_t thread) {
        parts_[thread].first_window = windows * thread / team.size();
        parts_[thread].last_window = windows * (thread + 1) / team.size();
        find(parts_[thread]);
        if (!parts_[thread].found.crowded) sort_windows(parts_[thread]);
    });
    for (const Part& part : parts_) {
        if (part.found.crowded) {
            throw TrajectoryError(
                fmt::format("a grain has more than {} neighbours", FoundNeighbours::most));
        }
    }
    team.run([&](std::size_t thread) { write_rows(parts_[thread], shape, list); });
    join(shape, team, list);
    return order_;
}

}  // namespace crossgrain::dem
