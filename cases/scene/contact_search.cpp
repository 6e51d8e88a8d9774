#include "cases/scene/contact_search.hpp"

#include "cases/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossgrain::scene {

ContactSearch::ContactSearch(double diameter, std::optional<double> period_x,
                             std::optional<double> period_y)
    : diameter_(diameter), period_x_(period_x), period_y_(period_y) {}

std::size_t ContactSearch::Axis::index(double position) const {
    double offset = position - origin;
    if (period) offset -= *period * std::floor(offset / *period);
    // Round-off may put a grain at the very end of the axis.
    return std::min(static_cast<std::size_t>(offset / cell), count - 1);
}

std::optional<std::size_t> ContactSearch::Axis::neighbour(std::size_t index, int step) const {
    if (step == 0) return index;
    const bool leaves = step < 0 ? index == 0 : index + 1 == count;
    if (!leaves) return step < 0 ? index - 1 : index + 1;
    if (!period || count < 3) return std::nullopt;
    return step < 0 ? count - 1 : 0;
}

ContactSearch::Axis ContactSearch::make_axis(std::span<const double> positions,
                                             const std::optional<double>& period) const {
    const auto most = std::max(3.0, 2.0 * std::sqrt(static_cast<double>(positions.size())));
    Axis axis;
    axis.period = period;
    double length = 0;
    if (period) {
        length = *period;
    } else {
        const auto [low, high] = std::minmax_element(positions.begin(), positions.end());
        axis.origin = *low;
        length = *high - *low;
    }
    const double count = std::floor(std::min(length / diameter_, most));
    const double least = period ? 3.0 : 1.0;
    axis.count = count < least ? 1 : static_cast<std::size_t>(count);
    axis.cell = std::max(length / static_cast<double>(axis.count), diameter_);
    return axis;
}

void ContactSearch::sort_into_cells(std::span<const double> x, std::span<const double> y) {
    const std::size_t n = x.size();
    cell_start_.assign(columns_.count * rows_.count + 1, 0);
    cell_of_.resize(n);
    members_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        cell_of_[i] = rows_.index(y[i]) * columns_.count + columns_.index(x[i]);
        ++cell_start_[cell_of_[i] + 1];
    }
    for (std::size_t c = 1; c < cell_start_.size(); ++c)
        cell_start_[c] += cell_start_[c - 1];
    std::vector<std::size_t> next(cell_start_.begin(), cell_start_.end() - 1);
    for (std::size_t i = 0; i < n; ++i)
        members_[next[cell_of_[i]]++] = i;
}

void ContactSearch::compare(std::size_t i, std::size_t j, std::span<const double> x,
                            std::span<const double> y) {
    if (i > j) std::swap(i, j);
    const double dx = nearest_image(x[i] - x[j], period_x_);
    const double dy = nearest_image(y[i] - y[j], period_y_);
    const double squared = dx * dx + dy * dy;
    if (squared >= diameter_ * diameter_) return;
    const double r = std::sqrt(squared);
    contacts_.push_back(r > 0 ? Contact{i, j, r, dx / r, dy / r} : Contact{i, j, 0.0, 1.0, 0.0});
}

void ContactSearch::compare_cells(std::size_t a, std::size_t b, std::span<const double> x,
                                  std::span<const double> y) {
    for (std::size_t p = cell_start_[a]; p < cell_start_[a + 1]; ++p) {
        const std::size_t first = a == b ? p + 1 : cell_start_[b];
        for (std::size_t q = first; q < cell_start_[b + 1]; ++q) {
            compare(members_[p], members_[q], x, y);
        }
    }
}

std::span<const Contact> ContactSearch::find(std::span<const double> x, std::span<const double> y) {
    contacts_.clear();
    if (x.empty()) return contacts_;
    columns_ = make_axis(x, period_x_);
    rows_ = make_axis(y, period_y_);
    sort_into_cells(x, y);
    // Half of the eight neighbours, so that every pair of cells is met once.
    static constexpr std::pair<int, int> half_stencil[] = {{0, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    for (std::size_t row = 0; row < rows_.count; ++row) {
        for (std::size_t column = 0; column < columns_.count; ++column) {
            const std::size_t cell = row * columns_.count + column;
            for (const auto& [right, up] : half_stencil) {
                const auto c = columns_.neighbour(column, right);
                const auto r = rows_.neighbour(row, up);
                if (c && r) compare_cells(cell, *r * columns_.count + *c, x, y);
            }
        }
    }
    return contacts_;
}

}  // namespace crossgrain::scene
