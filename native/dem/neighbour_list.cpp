#include "native/dem/neighbour_list.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace crossgrain::dem {
namespace {

double shift_to_nearest(double separation, const std::optional<double>& period) {
    return period ? -*period * std::round(separation / *period) : 0.0;
}

}  // namespace

/// Division of one axis into cells at least `range_` wide; a dilute system gets fewer, larger ones.
struct NeighbourList::Axis {
    double low = 0;
    double length = 0;
    int cells = 1;
    bool periodic = false;

    [[nodiscard]] int cell_of(double value) const {
        if (!(length > 0)) return 0;
        double offset = value - low;
        if (periodic) offset -= length * std::floor(offset / length);
        return std::clamp(static_cast<int>(offset / length * cells), 0, cells - 1);
    }

    /// Calls visit(n) for the cells next to `c` and `c` itself, each once.
    template <class Visit>
    void neighbours_of(int c, Visit visit) const {
        if (cells < 3) {
            for (int n = 0; n < cells; ++n)
                visit(n);
            return;
        }
        for (int n = c - 1; n <= c + 1; ++n) {
            if (periodic) {
                visit((n + cells) % cells);
            } else if (n >= 0 && n < cells) {
                visit(n);
            }
        }
    }
};

/// Grains sorted by cell: those of cell c are order[start[c]] ... order[start[c + 1] - 1].
struct NeighbourList::Cells {
    Axis x, y;
    std::vector<std::uint32_t> start;
    std::vector<std::uint32_t> order;

    [[nodiscard]] std::size_t index(int cx, int cy) const {
        return static_cast<std::size_t>(cy) * static_cast<std::size_t>(x.cells) +
               static_cast<std::size_t>(cx);
    }
};

NeighbourList::NeighbourList(double reach, double skin, std::optional<double> period_x,
                             std::optional<double> period_y)
    : range_(reach + skin), skin_(skin), period_x_(period_x), period_y_(period_y) {}

void NeighbourList::update(std::span<const double> x, std::span<const double> y) {
    if (builds_ == 0 || outdated(x, y)) build(x, y);
}

bool NeighbourList::outdated(std::span<const double> x, std::span<const double> y) const {
    const double limit = skin_ * skin_ / 4;
    unsigned moved = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = x[i] - x_built_[i];
        const double dy = y[i] - y_built_[i];
        // Written so that a NaN counts as moved.
        moved |= dx * dx + dy * dy <= limit ? 0U : 1U;
    }
    return moved != 0;
}

/// Also the place where a run that has blown up is noticed: cell indices need finite positions.
NeighbourList::Axis NeighbourList::make_axis(std::span<const double> values,
                                             const std::optional<double>& period, char name) const {
    double low = values.front();
    double high = values.front();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(std::abs(values[i]) < 1e12 * range_)) {
            throw TrajectoryError(
                fmt::format("grain {} has left all bounds ({} = {:g})", i, name, values[i]));
        }
        low = std::min(low, values[i]);
        high = std::max(high, values[i]);
    }
    // Four times as many cells along one axis as a square packing would fill is enough.
    const double most = 4 * std::ceil(std::sqrt(static_cast<double>(values.size())));
    Axis axis{.low = period ? 0.0 : low,
              .length = period ? *period : high - low,
              .periodic = period.has_value()};
    axis.cells = std::max(1, static_cast<int>(std::min(axis.length / range_, most)));
    return axis;
}

NeighbourList::Cells NeighbourList::make_cells(std::span<const double> x,
                                               std::span<const double> y) const {
    Cells cells{.x = make_axis(x, period_x_, 'x'),
                .y = make_axis(y, period_y_, 'y'),
                .start = {},
                .order = {}};
    std::vector<std::size_t> cell(x.size());
    cells.start.assign(cells.index(0, cells.y.cells) + 1, 0);
    for (std::size_t i = 0; i < x.size(); ++i) {
        cell[i] = cells.index(cells.x.cell_of(x[i]), cells.y.cell_of(y[i]));
        ++cells.start[cell[i] + 1];
    }
    for (std::size_t c = 1; c < cells.start.size(); ++c)
        cells.start[c] += cells.start[c - 1];
    cells.order.resize(x.size());
    std::vector<std::uint32_t> next(cells.start.begin(), cells.start.end() - 1);
    for (std::size_t i = 0; i < x.size(); ++i) {
        cells.order[next[cell[i]]++] = static_cast<std::uint32_t>(i);
    }
    return cells;
}

void NeighbourList::build(std::span<const double> x, std::span<const double> y) {
    pairs_.clear();
    if (!x.empty()) pair_up(make_cells(x, y), x, y);
    x_built_.assign(x.begin(), x.end());
    y_built_.assign(y.begin(), y.end());
    ++builds_;
}

void NeighbourList::pair_up(const Cells& cells, std::span<const double> x,
                            std::span<const double> y) {
    const double range_squared = range_ * range_;
    const auto try_pair = [&](std::uint32_t i, std::uint32_t j) {
        const double shift_x = shift_to_nearest(x[i] - x[j], period_x_);
        const double shift_y = shift_to_nearest(y[i] - y[j], period_y_);
        const double dx = x[i] - x[j] + shift_x;
        const double dy = y[i] - y[j] + shift_y;
        if (dx * dx + dy * dy < range_squared) pairs_.push_back({i, j, shift_x, shift_y});
    };
    const auto pair_with_cell = [&](std::uint32_t i, std::size_t c) {
        for (auto k = cells.start[c]; k < cells.start[c + 1]; ++k) {
            if (i < cells.order[k]) try_pair(i, cells.order[k]);
        }
    };
    for (int cy = 0; cy < cells.y.cells; ++cy) {
        for (int cx = 0; cx < cells.x.cells; ++cx) {
            const std::size_t c = cells.index(cx, cy);
            for (auto k = cells.start[c]; k < cells.start[c + 1]; ++k) {
                cells.y.neighbours_of(cy, [&](int ny) {
                    cells.x.neighbours_of(
                        cx, [&](int nx) { pair_with_cell(cells.order[k], cells.index(nx, ny)); });
                });
            }
        }
    }
}

}  // namespace crossgrain::dem
