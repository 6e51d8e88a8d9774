#include "native/friction/simd_kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace crossgrain::friction {
namespace {

/// No margin is wider than this, however fast the grain.
constexpr double widest_margin_in_radii = 8;

std::size_t memories_of(const ContactParameters& c) {
    if (c.tangential != TangentialForce::spring) return 0;
    switch (c.conventions.rotation) {
    case SpringRotation::project:
        break;
    case SpringRotation::project_and_rescale:
        return 1;
    case SpringRotation::rotate:
        return 4;
    }
    return 2;
}

}  // namespace

SimdKernel::SimdKernel(const Parameters& parameters, State initial)
    : p_(parameters), s_(std::move(initial)), memories_(memories_of(p_.contact)),
      functions_(step_functions(p_.contact)), search_(p_.period_x, p_.period_y),
      carrier_(s_.x.size()) {
    if (s_.x.empty()) return;
    largest_radius_ = *std::max_element(s_.radius.begin(), s_.radius.end());
    widest_margin_ =
        std::min(widest_margin_in_radii * largest_radius_, search_.widest_margin(largest_radius_));
    place_grains();
    list_pairs();
    add_contact_forces(0);
    auto task = motion_task();
    // A kick of no time leaves the velocities and makes accelerations of forces.
    task.dt = 0;
    functions_.close(task);
}

void SimdKernel::place_grains() {
    std::vector<bool> frozen(s_.x.size(), false);
    for (const std::size_t i : s_.frozen)
        frozen[i] = true;
    mobile_ = static_cast<std::size_t>(std::count(frozen.begin(), frozen.end(), false));
    padding_ = mobile_ % 2;
    places_ = s_.x.size() + padding_ + 1;
    for (Places* places : {&now_, &sorted_}) {
        for (auto* values : {&places->position, &places->velocity, &places->own, &places->torque})
            values->assign(4 * places_, 0.0);
        places->radius.assign(places_, 0.0);
        places->mass.assign(places_, 0.0);
        places->grain.assign(places_, no_grain);
    }
    for (auto* values : {&force_, &listed_})
        values->assign(4 * places_, 0.0);
    margin_.assign(4 * places_, std::numeric_limits<double>::infinity());
    std::size_t next_mobile = 0, next_frozen = mobile_ + padding_;
    for (std::size_t i = 0; i < s_.x.size(); ++i) {
        const std::size_t k = frozen[i] ? next_frozen++ : next_mobile++;
        const double r = s_.radius[i], m = s_.mass[i];
        const double inertia = p_.inertia_factor * m * r * r;
        now_.grain[k] = static_cast<std::uint32_t>(i);
        now_.radius[k] = r;
        now_.mass[k] = m;
        const double position[] = {s_.x[i], s_.y[i], 0, 0};
        const double velocity[] = {s_.vx[i], s_.vy[i], s_.omega[i], s_.omega[i] * r};
        const double own[] = {1 / m, 1 / m, -r / inertia, -r * r / inertia};
        const double torque[] = {0, 0, 1 / inertia, r / inertia};
        std::copy_n(position, 4, &now_.position[4 * k]);
        std::copy_n(velocity, 4, &now_.velocity[4 * k]);
        std::copy_n(own, 4, &now_.own[4 * k]);
        std::copy_n(torque, 4, &now_.torque[4 * k]);
    }
}

MotionTask SimdKernel::motion_task() {
    MotionTask task{.position = now_.position.data(),
                    .velocity = now_.velocity.data(),
                    .force = force_.data(),
                    .own = now_.own.data(),
                    .torque = now_.torque.data(),
                    .listed = listed_.data(),
                    .margin = margin_.data(),
                    .numbers = 4 * (mobile_ + padding_),
                    .dt = p_.dt,
                    .gravity = p_.gravity,
                    .drag = p_.drag,
                    .left_margin = &left_margin_};
    if (p_.backing) {
        task.backing_stiffness = p_.backing->stiffness;
        task.left = p_.backing->left;
        task.right = p_.backing->right;
    }
    return task;
}

void SimdKernel::add_contact_forces(double spring_time) {
    const auto& c = p_.contact;
    functions_.add_contact_forces(
        {.position = now_.position.data(),
         .velocity = now_.velocity.data(),
         .force = force_.data(),
         .pairs = &pairs_,
         .stiffness = c.stiffness,
         .damping = c.damping,
         .lowest_normal_force =
             c.tail == AttractiveTail::cut ? 0.0 : -std::numeric_limits<double>::infinity(),
         .friction = c.friction,
         .tangential_stiffness = c.tangential_stiffness,
         .tangential_damping = c.tangential_damping,
         .spring_time = spring_time});
    ++evaluations_;
}

void SimdKernel::relist_if_needed() {
    if (left_margin_) list_pairs();
}

/// Between two calls the velocities are those at whole steps and force_ has the accelerations.
void SimdKernel::advance(std::int64_t steps) {
    if (steps <= 0) return;
    state_is_current_ = false;
    if (s_.x.empty()) {
        s_.step += steps;
        return;
    }
    functions_.open(motion_task());
    for (std::int64_t n = 1;; ++n) {
        ++s_.step;
        relist_if_needed();
        add_contact_forces(p_.dt);
        if (n == steps) break;
        functions_.full(motion_task());
    }
    functions_.close(motion_task());
}

const State& SimdKernel::state() {
    if (state_is_current_) return s_;
    state_is_current_ = true;
    for (std::size_t k = 0; k < mobile_; ++k) {
        const std::size_t i = now_.grain[k];
        const double* position = &now_.position[4 * k];
        const double* velocity = &now_.velocity[4 * k];
        s_.x[i] = position[0] + position[2];
        s_.y[i] = position[1] + position[3];
        s_.vx[i] = velocity[0];
        s_.vy[i] = velocity[1];
        s_.omega[i] = velocity[2];
    }
    return s_;
}

Effort SimdKernel::effort() const {
    return {.kernel = fmt::format("simd ({})", functions_.instruction_set),
            .force_evaluations = evaluations_,
            .neighbour_builds = builds_,
            .pairs = static_cast<double>(pairs_.i.size()) /
                     static_cast<double>(std::max<std::size_t>(mobile_, 1))};
}

std::unique_ptr<StepKernel> make_simd_kernel(const Parameters& parameters, State state) {
    return std::make_unique<SimdKernel>(parameters, std::move(state));
}

}  // namespace crossgrain::friction
