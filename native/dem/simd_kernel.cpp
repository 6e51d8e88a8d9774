// Velocity Verlet for many grains: vectors, threads, one pass per step. The order of things:
//   open    half a kick and the drift, from whole steps to the kernel's own rhythm
//   full    forces, two half kicks, drift; again and again
//   close   forces and half a kick: back to a whole step, so that the state can be looked at
// Positions are looked over after every drift and before the next forces. Frames change nothing:
// open and close round as full does.
#include "native/base/errors.hpp"
#include "native/dem/kernel.hpp"
#include "native/dem/padded_list.hpp"
#include "native/dem/simd_coordinates.hpp"
#include "native/dem/simd_step.hpp"
#include "native/dem/skin_tuning.hpp"
#include "native/dem/thread_team.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>

namespace crossgrain::dem {
namespace {

// The second shell of a dense packing stays out at first; the tuning finds its way from there.
constexpr double first_skin_in_diameters = 0.45;
constexpr double narrowest_skin_in_diameters = 0.1;
constexpr double widest_skin_in_diameters = 1.0;

/// A step is worth a handshake between threads from so many grains per thread on.
constexpr std::size_t grains_per_thread = 4096;

int useful_threads(const Parameters& p, std::size_t grains) {
    const std::size_t most = std::max<std::size_t>(grains / grains_per_thread, 1);
    return static_cast<int>(std::min(static_cast<std::size_t>(std::max(p.threads, 1)), most));
}

/// values[i] = what was at order[i]; what lies beyond the order stays.
template <class Values>
void reorder(Values& values, const std::vector<std::uint32_t>& order) {
    const Values old = values;
    for (std::size_t i = 0; i < order.size(); ++i)
        values[i] = old[order[i]];
}

template <class Format>
class SimdKernel final : public StepKernel {
  public:
    SimdKernel(const Parameters& parameters, State initial, const StepFunctions<Format>& functions);

    void advance(std::int64_t steps) override;
    const State& state() override;
    [[nodiscard]] MissedContacts missed_contacts() const override { return {}; }
    [[nodiscard]] Effort effort() const override;

  private:
    using Real = typename Format::Real;
    using Record = typename Format::Record;
    using Function = typename StepFunctions<Format>::Function;

    void set_constants();
    void set_units();
    void run(Function function, Records<Format>& out);
    void push_lid(int kicks);
    void drift_lid();
    void look_over();
    void plan_survey(const Survey& s);
    [[nodiscard]] Survey survey();
    void make_list();
    void follow_grains();
    void check_grains() const;
    void wrap_grains();
    void sort_and_list();
    void write_records();
    [[nodiscard]] std::size_t groups() const { return padded_ / functions_.lanes; }

    Parameters p_;
    State state_;
    bool state_is_old_ = false;
    StepFunctions<Format> functions_;
    ThreadTeam team_;
    Coordinates<Format> coordinates_;
    StepConstants<Format> constants_;
    SkinTuning tuning_;

    std::size_t grains_, padded_;
    std::vector<std::uint32_t> number_;        ///< of the grain at a place, as it was given
    Records<Format> now_, next_, listed_;      ///< shape (padded + 1)
    std::vector<Real> own_x_, own_y_;          ///< shape (padded), see StepTask
    std::vector<double> listed_x_, listed_y_;  ///< when the list was made, x within the period
    std::vector<double> turns_;                ///< periods to add to x
    PaddedListMaker maker_;
    PaddedList list_;
    double lid_acceleration_ = 0;
    std::vector<double> lid_overlap_;

    bool exceeded_ = false;
    double skin_ = 0;  ///< of the present list
    Real drift_x_ = 0, drift_y_ = 0, speed_limit_ = 0;
    double centre_x_ = 0, centre_y_ = 0;
    std::int64_t steps_of_list_ = 0;
    std::int64_t steps_to_survey_ = 0, steps_since_survey_ = 0;
    std::int64_t evaluations_ = 0, builds_ = 0;
};

template <class Format>
SimdKernel<Format>::SimdKernel(const Parameters& parameters, State initial,
                               const StepFunctions<Format>& functions)
    : p_(parameters), state_(std::move(initial)), functions_(functions),
      team_(useful_threads(parameters, state_.x.size())), coordinates_(parameters),
      tuning_(p_.skin > 0 ? p_.skin : first_skin_in_diameters * p_.diameter,
              p_.skin > 0 ? p_.skin : narrowest_skin_in_diameters * p_.diameter,
              p_.skin > 0 ? p_.skin : widest_skin_in_diameters * p_.diameter),
      grains_(state_.x.size()),
      padded_((grains_ + functions.lanes - 1) / functions.lanes * functions.lanes),
      number_(grains_), now_(padded_ + 1), next_(padded_ + 1), listed_(padded_ + 1),
      own_x_(padded_), own_y_(padded_), listed_x_(state_.x), listed_y_(state_.y), turns_(grains_),
      lid_overlap_(padded_ / grains_per_block + 1) {
    set_constants();
    std::iota(number_.begin(), number_.end(), 0U);
    for (std::size_t i = 0; i < grains_; ++i) {
        now_[i].vx = static_cast<Real>(state_.vx[i]);
        now_[i].vy = static_cast<Real>(state_.vy[i]);
    }
    make_list();
    // Only for the accelerations; nothing has moved yet.
    run(functions_.close, next_);
    push_lid(0);
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
    StepTask<Format> task{.constants = &constants_,
                          .list = &list_,
                          .in = now_.data(),
                          .out = out.data(),
                          .own_x = own_x_.data(),
                          .own_y = own_y_.data(),
                          .grains = grains_,
                          .lid_overlap = lid_overlap_.data(),
                          .drift_x = drift_x_,
                          .drift_y = drift_y_,
                          .speed_limit_squared = speed_limit_ * speed_limit_};
    const double t = static_cast<double>(state_.step) * p_.dt;
    if (p_.bottom) task.bottom = coordinates_.plate(p_.bottom->position(t) + p_.plate_reach);
    if (const auto* plate = std::get_if<MovingPlate>(&p_.lid)) {
        task.lid = coordinates_.plate(plate->position(t) - p_.plate_reach);
    } else if (constants_.has_lid) {
        task.lid = coordinates_.plate(state_.lid_height - p_.plate_reach);
    }
    std::fill(lid_overlap_.begin(), lid_overlap_.end(), 0.0);
    std::atomic<bool> exceeded = false;
    team_.split(groups(), grains_per_block / functions_.lanes,
                [&](std::size_t begin, std::size_t end) {
                    StepTask<Format> part = task;
                    bool exceeded_here = false;
                    part.first_group = begin;
                    part.last_group = end;
                    part.exceeded = &exceeded_here;
                    function(part);
                    if (exceeded_here) exceeded.store(true, std::memory_order_relaxed);
                });
    exceeded_ = exceeded;
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

/// While no grain is faster than the limit relative to the common drift, grains part from their
/// common displacement by at most limit dt per step: until then nobody needs to look.
template <class Format>
void SimdKernel<Format>::look_over() {
    ++steps_of_list_;
    ++steps_since_survey_;
    if (!exceeded_ && --steps_to_survey_ > 0) return;
    const double elapsed = static_cast<double>(steps_since_survey_) * p_.dt;
    centre_x_ += static_cast<double>(drift_x_) * elapsed;
    centre_y_ += static_cast<double>(drift_y_) * elapsed;
    Survey s = survey();
    if (s.largest_distance_squared > skin_ * skin_ / 4) {
        centre_x_ = s.x.middle();
        centre_y_ = s.y.middle();
        s = survey();
    }
    plan_survey(s);
    const double common = std::max(std::abs(centre_x_), std::abs(centre_y_));
    if (!s.finite || steps_to_survey_ < 1 || common > coordinates_.longest_drift()) make_list();
}

template <class Format>
void SimdKernel<Format>::plan_survey(const Survey& s) {
    const double speed = std::hypot(s.vx.high - s.vx.low, s.vy.high - s.vy.low) / 2;
    // Some room for grains that get faster, and for a system at rest that begins to move.
    const double limit = 1.3 * speed + 4 * p_.gravity * p_.dt + 1e-6 * p_.diameter / p_.dt;
    drift_x_ = static_cast<Real>(s.vx.middle());
    drift_y_ = static_cast<Real>(s.vy.middle());
    speed_limit_ = static_cast<Real>(limit);
    const double room = 0.999 * skin_ / 2 - std::sqrt(s.largest_distance_squared);
    steps_to_survey_ = static_cast<std::int64_t>(std::clamp(room / (limit * p_.dt), 0.0, 1e9));
    steps_since_survey_ = 0;
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

template <class Format>
const State& SimdKernel<Format>::state() {
    if (!state_is_old_) return state_;
    for (std::size_t i = 0; i < grains_; ++i) {
        const std::size_t n = number_[i];
        state_.x[n] = coordinates_.x_now(listed_x_[i], listed_[i].x, now_[i].x) +
                      turns_[i] * p_.period_x.value_or(0.0);
        state_.y[n] = coordinates_.y_now(listed_y_[i], listed_[i].y, now_[i].y);
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
            .looked_at = static_cast<double>(list_.offsets.size()) / static_cast<double>(grains_)};
}

}  // namespace

std::unique_ptr<StepKernel> make_simd_kernel(const Parameters& parameters, State state) {
    if (parameters.precision == Precision::mixed) {
        return std::make_unique<SimdKernel<MixedFormat>>(parameters, std::move(state),
                                                         mixed_step_functions(parameters));
    }
    return std::make_unique<SimdKernel<DoubleFormat>>(parameters, std::move(state),
                                                      double_step_functions(parameters));
}

}  // namespace crossgrain::dem
