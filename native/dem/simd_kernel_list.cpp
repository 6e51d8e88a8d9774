// The neighbour list of the kernel: when it is made anew, grains are followed, checked, wrapped
// into the period and sorted, and their records written.
#include "native/base/errors.hpp"
#include "native/dem/simd_kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace crossgrain::dem {
namespace {

/// values[i] = what was at order[i]; what lies beyond the order stays.
template <class Values>
void reorder(Values& values, const std::vector<std::uint32_t>& order) {
    const Values old = values;
    for (std::size_t i = 0; i < order.size(); ++i)
        values[i] = old[order[i]];
}

}  // namespace

template <class Format>
void SimdKernel<Format>::make_list() {
    if (builds_ > 0) {
        follow_grains();
        if (p_.skin == 0) {
            tuning_.list_has_lasted(steps_of_list_, static_cast<double>(list_.first_row.back()) /
                                                        static_cast<double>(groups()));
        }
    }
    check_grains();
    skin_ = tuning_.skin();
    sort_and_list();
    ++builds_;
    steps_of_list_ = 0;
    centre_x_ = centre_y_ = 0;
    const Survey s = survey();
    plan_survey(s);
    const double fastest = static_cast<double>(speed_limit_) * p_.dt;
    if (!s.finite || fastest > coordinates_.longest_drift()) {
        throw TrajectoryError(fmt::format("a grain moves by {:g} in the step at t = {:g}", fastest,
                                          static_cast<double>(state_.step) * p_.dt));
    }
    steps_to_survey_ = std::max<std::int64_t>(steps_to_survey_, 1);
}

/// Where the grains have come.
template <class Format>
void SimdKernel<Format>::follow_grains() {
    team_.split(grains_, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            listed_x_[i] = coordinates_.x_now(listed_x_[i], listed_[i].x, now_[i].x);
            listed_y_[i] = coordinates_.y_now(listed_y_[i], listed_[i].y, now_[i].y);
        }
    });
}

template <class Format>
void SimdKernel<Format>::check_grains() const {
    for (std::size_t i = 0; i < grains_; ++i) {
        const double bound = 1e12 * p_.diameter;
        // Written so that what is no number is out of bounds.
        if (!(std::abs(listed_x_[i]) < bound) || !(std::abs(listed_y_[i]) < bound) ||
            !std::isfinite(now_[i].vx) || !std::isfinite(now_[i].vy)) {
            throw TrajectoryError(
                fmt::format("grain {} has left all bounds (x = {:g}, y = {:g}, v = {:g}, {:g})",
                            number_[i], listed_x_[i], listed_y_[i], now_[i].vx, now_[i].vy));
        }
    }
}

/// Into [0, period); only grains that have left it are touched, so that the others are not rounded.
template <class Format>
void SimdKernel<Format>::wrap_grains() {
    const double period = *p_.period_x;
    for (std::size_t i = 0; i < grains_; ++i) {
        double& x = listed_x_[i];
        if (x >= 0 && x < period) continue;
        const double turns = std::floor(x / period);
        turns_[i] += turns;
        x -= turns * period;
        if (x >= period || x < 0) x = 0;  // a rounding away from the edge
    }
}

template <class Format>
void SimdKernel<Format>::sort_and_list() {
    if (p_.period_x) wrap_grains();
    const auto& order = maker_.make(listed_x_, listed_y_,
                                    {.diameter = p_.diameter,
                                     .skin = skin_,
                                     .period_x = p_.period_x,
                                     .lanes = functions_.lanes,
                                     .record_size = sizeof(Record)},
                                    team_, list_);
    for (auto* values : {&listed_x_, &listed_y_, &turns_})
        reorder(*values, order);
    reorder(number_, order);
    reorder(own_x_, order);
    reorder(own_y_, order);
    reorder(now_, order);
    const auto [low, high] = std::minmax_element(listed_y_.begin(), listed_y_.end());
    coordinates_.fit(*low, *high);
    set_units();
    write_records();
}

/// Positions as the format has them; lanes beyond the last grain repeat it.
template <class Format>
void SimdKernel<Format>::write_records() {
    for (std::size_t i = 0; i < grains_; ++i) {
        now_[i].x = coordinates_.x(listed_x_[i]);
        now_[i].y = coordinates_.y(listed_y_[i]);
    }
    for (std::size_t i = grains_; i < padded_; ++i) {
        now_[i] = now_[grains_ - 1];
        own_x_[i] = own_x_[grains_ - 1];
        own_y_[i] = own_y_[grains_ - 1];
    }
    now_[padded_] = Record{.x = 0, .y = coordinates_.dummy_y(), .vx = 0, .vy = 0};
    next_[padded_] = now_[padded_];
    listed_ = now_;
}

template void SimdKernel<MixedFormat>::make_list();
template void SimdKernel<DoubleFormat>::make_list();

}  // namespace crossgrain::dem
