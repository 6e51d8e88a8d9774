#include "native/dem/simd_kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace crossgrain::dem {
namespace {

// The second shell of a dense packing stays out at first; the tuning finds its way from there.
constexpr double first_skin_in_diameters = 0.6;
constexpr double narrowest_skin_in_diameters = 0.1;
constexpr double widest_skin_in_diameters = 1.0;

/// Displacements are sums of rounded steps.
constexpr double within_rounding = 0.999;

/// A step is worth a handshake between threads from so many grains per thread on.
constexpr std::size_t grains_per_thread = 4096;

/// From here on records come from afar, and are called for before their neighbours need them:
/// beyond the next columns of a bed and a window of the list, but well within a cache.
constexpr std::size_t fits_in_cache = std::size_t{512} * 1024;
constexpr std::size_t grains_ahead = 1024;

/// From here on no cache keeps the records until the next step.
constexpr std::size_t fits_in_no_cache = std::size_t{16} * 1024 * 1024;

/// How far contacts may bring two grains nearer, in diameters, before rows are ordered anew, and
/// how many steps at least and at most that may take. Fewer steps, fewer rows; the optimum is flat.
constexpr double nearer_by_contacts = 0.1;
constexpr double fewest_steps_of_order = 8, most_steps_of_order = 256;

/// A list that is good for less than this part of those steps is made anew.
constexpr double least_part_of_order = 0.25;

/// The limit of accelerations follows them: up when it is exceeded, which costs an order of rows,
/// down with every other one.
constexpr double limit_rises = 1.5, limit_falls = 0.97;

/// What the limit is at least: the acceleration at an overlap of so many diameters; without
/// springs, one that brings grains nearer by next to nothing in a step.
constexpr double least_overlap = 1e-3, least_nearer = 1e-9;

int useful_threads(const Parameters& p, std::size_t grains) {
    const std::size_t most = std::max<std::size_t>(grains / grains_per_thread, 1);
    return static_cast<int>(std::min(static_cast<std::size_t>(std::max(p.threads, 1)), most));
}

}  // namespace

template <class Format>
SimdKernel<Format>::SimdKernel(const Parameters& parameters, State initial,
                               const StepFunctions<Format>& functions)
    : p_(parameters), state_(std::move(initial)), functions_(functions),
      team_(useful_threads(parameters, state_.x.size())), coordinates_(parameters),
      tuning_(p_.skin > 0 ? p_.skin : first_skin_in_diameters * p_.diameter,
              p_.skin > 0 ? p_.skin : narrowest_skin_in_diameters * p_.diameter,
              p_.skin > 0 ? p_.skin : widest_skin_in_diameters * p_.diameter),
      grains_(state_.x.size()), padded_((grains_ + functions.group.lanes - 1) /
                                        functions.group.lanes * functions.group.lanes),
      now_(padded_ + 1), next_(padded_ + 1), listed_(padded_ + 1),
      lid_overlap_(padded_ / grains_per_block + 1), told_(team_.size()),
      least_acceleration_limit_(p_.diameter * std::max(least_overlap * p_.stiffness / p_.mass,
                                                       least_nearer / (p_.dt * p_.dt))),
      acceleration_limit_(least_acceleration_limit_) {
    set_constants();
    for (Places* places : {&places_, &spare_}) {
        places->number.resize(grains_);
        for (auto* values : {&places->x, &places->y, &places->turns})
            values->resize(grains_);
        for (auto* values : {&places->own_x, &places->own_y})
            values->resize(padded_);
    }
    std::iota(places_.number.begin(), places_.number.end(), 0U);
    places_.x = state_.x;
    places_.y = state_.y;
    for (std::size_t i = 0; i < grains_; ++i) {
        now_[i].vx = static_cast<Real>(state_.vx[i]);
        now_[i].vy = static_cast<Real>(state_.vy[i]);
    }
    make_list();
    // Only for the accelerations; nothing has moved yet.
    run(functions_.close, next_);
    push_lid(0);
    for (std::size_t i = 0; i < padded_; ++i) {
        const double ax = places_.own_x[i], ay = places_.own_y[i] + p_.gravity;
        acceleration_limit_ = std::max(acceleration_limit_, limit_rises * std::hypot(ax, ay));
    }
    // The order relies on the limit.
    order_rows(steps_left(survey()));
}

template <class Format>
void SimdKernel<Format>::set_constants() {
    constants_.diameter = static_cast<Real>(p_.diameter);
    constants_.stiffness = static_cast<Real>(p_.stiffness);
    constants_.damping = static_cast<Real>(p_.damping);
    constants_.inverse_mass = static_cast<Real>(1 / p_.mass);
    constants_.gravity = static_cast<Real>(p_.gravity);
    constants_.dt = static_cast<Real>(p_.dt);
    if (p_.period_x) {
        constants_.period = static_cast<Real>(*p_.period_x);
        constants_.inverse_period = static_cast<Real>(1 / *p_.period_x);
    }
    constants_.plate_stiffness = static_cast<Real>(p_.plate_stiffness);
    constants_.has_bottom = p_.bottom.has_value();
    constants_.has_lid = !std::holds_alternative<std::monostate>(p_.lid);
}

template <class Format>
void SimdKernel<Format>::set_units() {
    constants_.unit_x = static_cast<Real>(coordinates_.unit_x());
    constants_.unit_y = static_cast<Real>(coordinates_.unit_y());
    constants_.steps_x = static_cast<Real>(p_.dt / coordinates_.unit_x());
    constants_.steps_y = static_cast<Real>(p_.dt / coordinates_.unit_y());
}

template <class Format>
void SimdKernel<Format>::run(Function function, Records<Format>& out) {
    StepTask<Format> task{
        .constants = &constants_,
        .list = &list_,
        .in = now_.data(),
        .out = out.data(),
        .own_x = places_.own_x.data(),
        .own_y = places_.own_y.data(),
        .grains = grains_,
        .ahead = grains_ * sizeof(Record) > fits_in_cache ? grains_ahead : grains_,
        .past_caches = grains_ * sizeof(Record) > fits_in_no_cache,
        .step = static_cast<float>(steps_of_order_ + 1),
        .lid_overlap = lid_overlap_.data(),
        .acceleration_limit_squared = static_cast<Real>(acceleration_limit_ * acceleration_limit_)};
    const double t = static_cast<double>(state_.step) * p_.dt;
    if (p_.bottom) task.bottom = coordinates_.plate(p_.bottom->position(t) + p_.plate_reach);
    if (const auto* plate = std::get_if<MovingPlate>(&p_.lid)) {
        task.lid = coordinates_.plate(plate->position(t) - p_.plate_reach);
    } else if (constants_.has_lid) {
        task.lid = coordinates_.plate(state_.lid_height - p_.plate_reach);
    }
    std::fill(lid_overlap_.begin(), lid_overlap_.end(), 0.0);
    std::fill(told_.begin(), told_.end(), Told{});
    team_.split(groups(), grains_per_block / functions_.group.lanes,
                [&](std::size_t begin, std::size_t end, std::size_t thread) {
                    StepTask<Format> part = task;
                    part.first_group = begin;
                    part.last_group = end;
                    part.exceeded = &told_[thread].exceeded;
                    part.rows = &told_[thread].rows;
                    function(part);
                });
    exceeded_ = false;
    for (const Told& part : told_) {
        exceeded_ = exceeded_ || part.exceeded;
        rows_ += part.rows;
    }
}

/// The lid's acceleration from the overlaps of the last forces, and so many half kicks by it.
template <class Format>
void SimdKernel<Format>::push_lid(int kicks) {
    ++evaluations_;
    const auto* lid = std::get_if<InertialLid>(&p_.lid);
    if (!lid) return;
    const double overlap = std::accumulate(lid_overlap_.begin(), lid_overlap_.end(), 0.0);
    const double push = p_.plate_stiffness * (overlap * coordinates_.unit_y());
    lid_acceleration_ = push / lid->mass - p_.gravity;
    // One by one: a full step has to round like a closed and an opened one.
    for (int kick = 0; kick < kicks; ++kick)
        state_.lid_velocity += p_.dt / 2 * lid_acceleration_;
}

template <class Format>
void SimdKernel<Format>::drift_lid() {
    state_.lid_height += state_.lid_velocity * p_.dt;
}

template <class Format>
void SimdKernel<Format>::advance(std::int64_t steps) {
    if (steps <= 0) return;
    state_is_old_ = true;
    run(functions_.open, now_);
    state_.lid_velocity += p_.dt / 2 * lid_acceleration_;
    drift_lid();
    for (std::int64_t left = steps;;) {
        ++state_.step;
        look_over();
        const bool last = --left == 0;
        run(last ? functions_.close : functions_.full, next_);
        now_.swap(next_);
        push_lid(last ? 1 : 2);
        if (last) return;
        drift_lid();
    }
}

/// After every drift: nothing, until it is time to order the rows anew, or contacts have been
/// stronger than thought.
template <class Format>
void SimdKernel<Format>::look_over() {
    ++steps_of_list_;
    ++steps_of_order_;
    if (!exceeded_ && steps_of_order_ < horizon_) return;
    acceleration_limit_ = std::max(least_acceleration_limit_,
                                   acceleration_limit_ * (exceeded_ ? limit_rises : limit_falls));
    Survey s = survey();
    if (s.largest_distance_squared > skin_ * skin_ / 16) {
        centre_x_ = s.x.middle();
        centre_y_ = s.y.middle();
        s = survey();
    }
    const std::int64_t left = steps_left(s);
    if (s.finite && static_cast<double>(left) >= least_part_of_order * steps_worth_an_order()) {
        order_rows(left);
    } else {
        make_list();
    }
}

/// For how many steps the list is good, as long as contacts stay within their limit A: grains that
/// have moved by D relative to the centre, and fly at the speed u relative to each other's middle,
/// are within D + m u dt + A dt^2 (m + 1)^2/2 of it after m steps, which must not be beyond half
/// the skin. What moves all grains alike, their mean flight and gravity, does not count, but must
/// not be more than coordinates allow.
template <class Format>
std::int64_t SimdKernel<Format>::steps_left(const Survey& s) const {
    const double moved = std::sqrt(s.largest_distance_squared);
    const double room = std::max(within_rounding * skin_ / 2 - moved, 0.0);
    const double by_flight = std::hypot(s.vx.high - s.vx.low, s.vy.high - s.vy.low) / 2 * p_.dt;
    const double by_contacts = acceleration_limit_ * p_.dt * p_.dt;
    const double in_room =
        2 * room / (by_flight + std::sqrt(by_flight * by_flight + 2 * by_contacts * room)) - 1;
    const double drift = std::max(std::abs(s.vx.middle()), std::abs(s.vy.middle())) +
                         p_.gravity * p_.dt * most_steps_of_order;
    const double drifted = std::max(std::abs(centre_x_), std::abs(centre_y_));
    const double in_bounds = (coordinates_.longest_drift() - drifted) / (drift * p_.dt);
    // Written so that what is no number is none.
    const double steps = std::min(in_room, in_bounds);
    return steps > 0 ? static_cast<std::int64_t>(std::min(steps, most_steps_of_order)) : 0;
}

template <class Format>
double SimdKernel<Format>::steps_worth_an_order() const {
    return std::clamp(std::sqrt(nearer_by_contacts * p_.diameter / acceleration_limit_) / p_.dt,
                      fewest_steps_of_order, most_steps_of_order);
}

/// By when they can touch, for as many steps as is worth it, of those that the list is good for.
template <class Format>
void SimdKernel<Format>::order_rows(std::int64_t steps_left) {
    horizon_ =
        std::clamp<std::int64_t>(steps_left, 1, static_cast<std::int64_t>(steps_worth_an_order()));
    team_.run([&](std::size_t thread) {
        functions_.order_rows({.constants = &constants_,
                               .now = now_.data(),
                               .list = &list_,
                               .first_group = groups() * thread / team_.size(),
                               .last_group = groups() * (thread + 1) / team_.size(),
                               .acceleration = acceleration_limit_ * p_.dt * p_.dt,
                               .horizon = static_cast<float>(horizon_)});
    });
    steps_of_order_ = 0;
    ++orders_of_list_;
}

template <class Format>
Survey SimdKernel<Format>::survey() {
    std::vector<Survey> parts(team_.size());
    team_.run([&](std::size_t thread) {
        const SurveyTask<Format> task{.constants = &constants_,
                                      .now = now_.data(),
                                      .listed = listed_.data(),
                                      .first_group = groups() * thread / team_.size(),
                                      .last_group = groups() * (thread + 1) / team_.size(),
                                      .centre_x = static_cast<Real>(centre_x_),
                                      .centre_y = static_cast<Real>(centre_y_)};
        parts[thread] = functions_.survey(task);
    });
    Survey all = parts.front();
    for (const Survey& part : parts)
        all.include(part);
    return all;
}

template <class Format>
const State& SimdKernel<Format>::state() {
    if (!state_is_old_) return state_;
    for (std::size_t i = 0; i < grains_; ++i) {
        const std::size_t n = places_.number[i];
        state_.x[n] = coordinates_.x_now(places_.x[i], listed_[i].x, now_[i].x) +
                      places_.turns[i] * p_.period_x.value_or(0.0);
        state_.y[n] = coordinates_.y_now(places_.y[i], listed_[i].y, now_[i].y);
        state_.vx[n] = now_[i].vx;
        state_.vy[n] = now_[i].vy;
    }
    state_is_old_ = false;
    return state_;
}

template <class Format>
Effort SimdKernel<Format>::effort() const {
    return {.kernel = fmt::format(
                "simd {} ({}){}", std::is_same_v<Format, MixedFormat> ? "mixed" : "double",
                functions_.instruction_set,
                team_.size() > 1 ? fmt::format(", {} threads", team_.size()) : std::string()),
            .force_evaluations = evaluations_,
            .neighbour_builds = builds_,
            .skin = skin_,
            .looked_at =
                static_cast<double>(rows_ * static_cast<std::int64_t>(functions_.group.lanes)) /
                static_cast<double>(static_cast<std::int64_t>(grains_) * evaluations_)};
}

template class SimdKernel<MixedFormat>;
template class SimdKernel<DoubleFormat>;

std::unique_ptr<StepKernel> make_simd_kernel(const Parameters& parameters, State state) {
    if (parameters.precision == Precision::mixed) {
        return std::make_unique<SimdKernel<MixedFormat>>(parameters, std::move(state),
                                                         mixed_step_functions(parameters));
    }
    return std::make_unique<SimdKernel<DoubleFormat>>(parameters, std::move(state),
                                                      double_step_functions(parameters));
}

}  // namespace crossgrain::dem
