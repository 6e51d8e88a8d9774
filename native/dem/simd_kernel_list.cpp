// The neighbour list of the kernel: when it is made anew, grains are followed, checked, wrapped
// into the period and sorted, and their records written.
#include "native/base/errors.hpp"
#include "native/dem/simd_kernel.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace crossgrain::dem {
template <class Format>
void SimdKernel<Format>::make_list() {
    if (builds_ > 0 && p_.skin == 0) {
        const auto rows = static_cast<double>(rows_ - rows_before_list_);
        tuning_.list_has_lasted(steps_of_list_, orders_of_list_,
                                rows / static_cast<double>(groups()));
    }
    follow_grains();
    skin_ = tuning_.skin();
    sort_and_list();
    ++builds_;
    steps_of_list_ = orders_of_list_ = 0;
    rows_before_list_ = rows_;
    centre_x_ = centre_y_ = 0;
    const Survey s = survey();
    const double step = std::hypot(s.vx.largest(), s.vy.largest()) * p_.dt;
    if (!s.finite || step > coordinates_.longest_drift()) {
        throw TrajectoryError(fmt::format("a grain moves by {:g} in the step at t = {:g}", step,
                                          static_cast<double>(state_.step) * p_.dt));
    }
    // It may be good for this step only.
    order_rows(steps_left(s));
}

/// Where the grains have come, within the period.
template <class Format>
void SimdKernel<Format>::follow_grains() {
    std::atomic<bool> any_lost = false;
    team_.split(grains_, 1, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i) {
            if (builds_ > 0) {
                places_.x[i] = coordinates_.x_now(places_.x[i], listed_[i].x, now_[i].x);
                places_.y[i] = coordinates_.y_now(places_.y[i], listed_[i].y, now_[i].y);
            }
            if (is_lost(i)) any_lost.store(true, std::memory_order_relaxed);
            if (p_.period_x) wrap(i);
        }
    });
    if (any_lost) tell_lost();
}

template <class Format>
bool SimdKernel<Format>::is_lost(std::size_t place) const {
    const double bound = 1e12 * p_.diameter;
    // Written so that what is no number is out of bounds.
    return !(std::abs(places_.x[place]) < bound) || !(std::abs(places_.y[place]) < bound) ||
           !std::isfinite(now_[place].vx) || !std::isfinite(now_[place].vy);
}

template <class Format>
void SimdKernel<Format>::tell_lost() const {
    std::size_t i = 0;
    while (i + 1 < grains_ && !is_lost(i))
        ++i;
    throw TrajectoryError(
        fmt::format("grain {} has left all bounds (x = {:g}, y = {:g}, v = {:g}, {:g})",
                    places_.number[i], places_.x[i], places_.y[i], now_[i].vx, now_[i].vy));
}

/// Into [0, period); only grains that have left it are touched, so that the others are not rounded.
template <class Format>
void SimdKernel<Format>::wrap(std::size_t place) {
    const double period = *p_.period_x;
    double& x = places_.x[place];
    if (x >= 0 && x < period) return;
    const double turns = std::floor(x / period);
    places_.turns[place] += turns;
    x -= turns * period;
    if (x >= period || x < 0) x = 0;  // a rounding away from the edge
}

template <class Format>
void SimdKernel<Format>::sort_and_list() {
    const auto& order = maker_.make(places_.x, places_.y,
                                    {.diameter = p_.diameter,
                                     .skin = skin_,
                                     .period_x = p_.period_x,
                                     .group = functions_.group,
                                     .record_size = sizeof(Record)},
                                    team_, list_);
    coordinates_.fit(maker_.heights().low, maker_.heights().high);
    set_units();
    move_to(order);
    pad();
}

/// Grains, and records with positions as the format has them, in the order of the list.
template <class Format>
void SimdKernel<Format>::move_to(const std::vector<std::uint32_t>& order) {
    // Nobody looks at these between two steps of the other scheme.
    const bool owns = p_.scheme == Scheme::verlet_predicted;
    const GroupShape group = functions_.group;
    team_.split(grains_, group.lanes, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t from = order[i];
            spare_.number[i] = places_.number[from];
            spare_.turns[i] = places_.turns[from];
            const double x = spare_.x[i] = places_.x[from];
            const double y = spare_.y[i] = places_.y[from];
            next_[i] = listed_[i] = Record{.x = coordinates_.x(x),
                                           .y = coordinates_.y(y),
                                           .vx = now_[from].vx,
                                           .vy = now_[from].vy};
            if (owns) {
                const std::size_t to_slot = group.slot_of_place(i);
                const std::size_t from_slot = group.slot_of_place(from);
                spare_.own_x[to_slot] = places_.own_x[from_slot];
                spare_.own_y[to_slot] = places_.own_y[from_slot];
            }
        }
    });
    std::swap(places_, spare_);
    now_.swap(next_);
}

/// Lanes beyond the last grain repeat it.
template <class Format>
void SimdKernel<Format>::pad() {
    const std::size_t last = functions_.group.slot_of_place(grains_ - 1);
    for (std::size_t i = grains_; i < padded_; ++i) {
        now_[i] = listed_[i] = now_[grains_ - 1];
        const std::size_t slot = functions_.group.slot_of_place(i);
        places_.own_x[slot] = places_.own_x[last];
        places_.own_y[slot] = places_.own_y[last];
    }
    const Record dummy{.x = 0, .y = coordinates_.dummy_y(), .vx = 0, .vy = 0};
    now_[padded_] = next_[padded_] = listed_[padded_] = dummy;
}

template void SimdKernel<MixedFormat>::make_list();
template void SimdKernel<DoubleFormat>::make_list();

}  // namespace crossgrain::dem
