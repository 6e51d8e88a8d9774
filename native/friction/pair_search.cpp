#include "native/friction/pair_search.hpp"

#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace crossgrain::friction {
namespace {

double wrap_of(double value, const std::optional<double>& period) {
    return period ? -*period * std::floor(value / *period) : 0.0;
}

/// Cells as wide as two typical margins beyond a contact: most discs look at 3 x 3 of them.
double cell_size(const DiscView& discs, double largest_radius) {
    double sum = 0;
    for (std::size_t k = 0; k < discs.mobile; ++k)
        sum += std::max(discs.margin_x[k], discs.margin_y[k]);
    return 2 * (largest_radius + sum / static_cast<double>(std::max<std::size_t>(discs.mobile, 1)));
}

}  // namespace

int PairSearch::Axis::cell_of(double wrapped) const {
    return std::clamp(static_cast<int>((wrapped - low) * per_length), 0, cells - 1);
}

PairSearch::PairSearch(std::optional<double> period_x, std::optional<double> period_y)
    : period_x_(period_x), period_y_(period_y) {}

double PairSearch::widest_margin(double largest_radius) const {
    double widest = std::numeric_limits<double>::infinity();
    for (const auto& period : {period_x_, period_y_}) {
        if (!period) continue;
        if (!(*period > 4 * largest_radius)) {
            throw std::invalid_argument(
                fmt::format("a period is {:g}, expected more than two diameters of the largest "
                            "grain, {:g}",
                            *period, 4 * largest_radius));
        }
        widest = std::min(widest, *period / 4 - largest_radius);
    }
    return widest;
}

/// Also the place where a run that has blown up is noticed: cells need finite positions.
PairSearch::Axis PairSearch::make_axis(std::span<const double> values,
                                       const std::optional<double>& period, double cell_size,
                                       char name) {
    double low = values.front(), high = values.front();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(std::abs(values[i]) < 1e9 * cell_size)) {
            throw TrajectoryError(
                fmt::format("grain {} has left all bounds ({} = {:g})", i, name, values[i]));
        }
        low = std::min(low, values[i]);
        high = std::max(high, values[i]);
    }
    // Four times as many cells along one axis as a square packing would fill is enough.
    const double most = 4 * std::ceil(std::sqrt(static_cast<double>(values.size())));
    const double length = period ? *period : high - low;
    Axis axis{.low = period ? 0.0 : low, .per_length = 0, .cells = 1, .period = period};
    axis.cells = std::max(1, static_cast<int>(std::min(length / cell_size, most)));
    axis.per_length = length > 0 ? axis.cells / length : 0;
    return axis;
}

/// The cells from position `from` to position `to`, across the period if need be.
void PairSearch::segments(const Axis& axis, double from, double to, std::vector<Segment>& found) {
    found.clear();
    if (!axis.period) {
        found.push_back({axis.cell_of(from), axis.cell_of(to), 0});
        return;
    }
    const auto cell = [&](double value) {
        return static_cast<int>(std::floor(value * axis.per_length));
    };
    const int last = cell(to);
    for (int first = cell(from); first <= last;) {
        const int image =
            first >= 0 ? first / axis.cells : -((axis.cells - 1 - first) / axis.cells);
        const int origin = image * axis.cells;
        const int end = std::min(last, origin + axis.cells - 1);
        found.push_back({first - origin, end - origin, -image * *axis.period});
        first = end + 1;
    }
}

void PairSearch::sort(const DiscView& discs) {
    const auto rows = static_cast<std::size_t>(axis_y_.cells);
    const std::size_t count = discs.x.size();
    start_.assign(static_cast<std::size_t>(axis_x_.cells) * rows + 1, 0);
    cell_.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const int column = axis_x_.cell_of(discs.x[k] + wrap_of(discs.x[k], period_x_));
        const int row = axis_y_.cell_of(discs.y[k] + wrap_of(discs.y[k], period_y_));
        cell_[k] = static_cast<std::uint32_t>(static_cast<std::size_t>(column) * rows +
                                              static_cast<std::size_t>(row));
        ++start_[cell_[k] + 1];
    }
    for (std::size_t c = 1; c < start_.size(); ++c)
        start_[c] += start_[c - 1];
    next_.assign(start_.begin(), start_.end() - 1);
    by_cell_.resize(count);
    for (std::size_t k = 0; k < count; ++k)
        by_cell_[next_[cell_[k]]++] = static_cast<std::uint32_t>(k);
    mobile_.clear();
    order_.resize(count);
    place_.resize(count);
    std::uint32_t frozen = static_cast<std::uint32_t>(discs.mobile);
    for (std::uint32_t q = 0; q < count; ++q) {
        const std::uint32_t disc = by_cell_[q];
        const bool is_mobile = disc < discs.mobile;
        place_[q] = is_mobile ? static_cast<std::uint32_t>(mobile_.size()) : frozen++;
        if (is_mobile) mobile_.push_back(q);
        order_[place_[q]] = disc;
    }
}

void PairSearch::copy_sorted(const DiscView& discs) {
    const std::size_t count = discs.x.size();
    for (auto* values : {&sorted_.x, &sorted_.y, &sorted_.radius, &sorted_.margin_x,
                         &sorted_.margin_y, &sorted_.margin, &wrap_x_, &wrap_y_}) {
        values->resize(count + SortedDiscs::padding);
    }
    for (std::size_t q = 0; q < count; ++q) {
        const std::size_t disc = by_cell_[q];
        const bool is_mobile = disc < discs.mobile;
        wrap_x_[q] = wrap_of(discs.x[disc], period_x_);
        wrap_y_[q] = wrap_of(discs.y[disc], period_y_);
        sorted_.x[q] = discs.x[disc] + wrap_x_[q];
        sorted_.y[q] = discs.y[disc] + wrap_y_[q];
        sorted_.radius[q] = discs.radius[disc];
        sorted_.margin_x[q] = is_mobile ? discs.margin_x[disc] : 0;
        sorted_.margin_y[q] = is_mobile ? discs.margin_y[disc] : 0;
        sorted_.margin[q] = is_mobile ? std::max(sorted_.margin_x[q], sorted_.margin_y[q]) : -1;
    }
}

/// The partners of a disc in a stretch of cells of one column.
void PairSearch::scan(std::size_t seeker, std::size_t first_cell, const Segment& columns,
                      const Segment& rows) {
    const std::size_t begin = start_[first_cell + static_cast<std::size_t>(rows.first)];
    const std::size_t end = start_[first_cell + static_cast<std::size_t>(rows.last) + 1];
    if (begin == end) return;
    if (found_.size() < end - begin) found_.resize(2 * (end - begin));
    const std::size_t count = scan_for_partners_(sorted_,
                                                 {.x = sorted_.x[seeker] + columns.shift,
                                                  .y = sorted_.y[seeker] + rows.shift,
                                                  .radius = sorted_.radius[seeker],
                                                  .margin_x = sorted_.margin_x[seeker],
                                                  .margin_y = sorted_.margin_y[seeker],
                                                  .margin = sorted_.margin[seeker],
                                                  .place = seeker},
                                                 begin, end, found_.data());
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t q = found_[k];
        pairs_.push_back({.i = place_[seeker],
                          .j = place_[q],
                          .shift_x = wrap_x_[seeker] - wrap_x_[q] + columns.shift,
                          .shift_y = wrap_y_[seeker] - wrap_y_[q] + rows.shift});
    }
}

void PairSearch::pair_up(std::size_t seeker) {
    const double x = sorted_.x[seeker], y = sorted_.y[seeker];
    const double range = sorted_.radius[seeker] + largest_radius_ + 2 * sorted_.margin[seeker];
    segments(axis_x_, x - range, x + range, columns_);
    segments(axis_y_, y - range, y + range, rows_);
    for (const Segment& columns : columns_) {
        for (int column = columns.first; column <= columns.last; ++column) {
            const std::size_t first_cell =
                static_cast<std::size_t>(column) * static_cast<std::size_t>(axis_y_.cells);
            for (const Segment& rows : rows_)
                scan(seeker, first_cell, columns, rows);
        }
    }
}

void PairSearch::find(const DiscView& discs) {
    pairs_.clear();
    order_.clear();
    if (discs.x.empty()) return;
    largest_radius_ = *std::max_element(discs.radius.begin(), discs.radius.end());
    const double size = cell_size(discs, largest_radius_);
    axis_x_ = make_axis(discs.x, period_x_, size, 'x');
    axis_y_ = make_axis(discs.y, period_y_, size, 'y');
    sort(discs);
    copy_sorted(discs);
    for (const std::size_t seeker : mobile_)
        pair_up(seeker);
}

}  // namespace crossgrain::friction
