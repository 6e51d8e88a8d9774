// Pair after pair in double precision, as contact_law.hpp writes it. The order of summation is part
// of the contract: certificates to the last digits rest on it.
#include "native/friction/contact_carrier.hpp"
#include "native/friction/contact_law.hpp"
#include "native/friction/kernel.hpp"
#include "native/friction/law_choice.hpp"
#include "native/friction/pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossgrain::friction {
namespace {

struct Pair {
    std::uint32_t i = 0, j = 0;
    double shift_x = 0, shift_y = 0;
    double damping = 0, tangential_damping = 0;
    ContactMemory memory;
};

class ScalarKernel final : public StepKernel {
  public:
    ScalarKernel(const Parameters& parameters, State initial);

    void advance(std::int64_t steps) override;
    const State& state() override;
    [[nodiscard]] Effort effort() const override {
        const double mobile = static_cast<double>(std::max<std::size_t>(mobile_, 1));
        return {.kernel = "scalar",
                .force_evaluations = evaluations_,
                .neighbour_builds = builds_,
                .pairs = static_cast<double>(pairs_.size()) / mobile};
    }

  private:
    [[nodiscard]] bool has_left_its_margin() const;
    void list_pairs();
    void wrap();
    [[nodiscard]] Pair pair_of(const NearPair& near) const;
    void kick();
    void drift();
    void compute_accelerations(double spring_time);
    template <class Law>
    void add_contact_forces(const Law& law, double spring_time);
    void add_other_forces();

    Parameters p_;
    State s_;  ///< its positions are wrapped
    std::vector<double> unwrap_x_, unwrap_y_;
    State shown_;                        ///< what state() has made of it
    std::vector<std::uint32_t> places_;  ///< mobile grains first
    std::size_t mobile_ = 0;
    double margin_ = 0;
    PairSearch search_;
    ContactCarrier carrier_;
    std::vector<Pair> pairs_;
    std::vector<double> listed_x_, listed_y_;  ///< positions when the list was made
    std::vector<double> ax_, ay_, alpha_;
    std::int64_t evaluations_ = 0, builds_ = 0;
};

ScalarKernel::ScalarKernel(const Parameters& parameters, State initial)
    : p_(parameters), s_(std::move(initial)), unwrap_x_(s_.x.size()), unwrap_y_(s_.x.size()),
      shown_(s_), search_(p_.period_x, p_.period_y), carrier_(s_.x.size()), ax_(s_.x.size()),
      ay_(s_.x.size()), alpha_(s_.x.size()) {
    std::vector<bool> frozen(s_.x.size(), false);
    for (const std::size_t i : s_.frozen)
        frozen[i] = true;
    for (const bool wanted : {false, true}) {
        for (std::size_t i = 0; i < s_.x.size(); ++i) {
            if (frozen[i] == wanted) places_.push_back(static_cast<std::uint32_t>(i));
        }
        if (!wanted) mobile_ = places_.size();
    }
    if (s_.x.empty()) return;
    const double largest = *std::max_element(s_.radius.begin(), s_.radius.end());
    // Half a radius each: the second shell of a dense packing stays out, lists last long.
    margin_ = std::min(0.5 * largest, search_.widest_margin(largest));
    list_pairs();
    compute_accelerations(0);
}

bool ScalarKernel::has_left_its_margin() const {
    for (std::size_t k = 0; k < mobile_; ++k) {
        const std::size_t i = places_[k];
        // Written so that a NaN has left.
        if (!(std::abs(s_.x[i] - listed_x_[i]) <= margin_ &&
              std::abs(s_.y[i] - listed_y_[i]) <= margin_))
            return true;
    }
    return false;
}

Pair ScalarKernel::pair_of(const NearPair& near) const {
    const auto grain = [&](std::uint32_t place) { return places_[search_.order()[place]]; };
    Pair pair{.i = grain(near.i),
              .j = grain(near.j),
              .shift_x = near.shift_x,
              .shift_y = near.shift_y,
              .damping = p_.contact.damping,
              .tangential_damping = p_.contact.tangential_damping,
              .memory = {}};
    if (p_.contact.damping_scale == DampingScale::effective_mass) {
        const double mi = s_.mass[pair.i], mj = s_.mass[pair.j];
        const double effective = near.j < mobile_ ? mi * mj / (mi + mj) : mi;
        pair.damping *= effective;
        pair.tangential_damping *= effective;
    }
    pair.memory = carrier_.find(pair.i, pair.j);
    return pair;
}

/// Into the period, as other codes do: v dt added to a smaller number is rounded less.
void ScalarKernel::wrap() {
    const auto wrap_axis = [](const std::optional<double>& period, std::vector<double>& values,
                              std::vector<double>& unwrap) {
        for (std::size_t i = 0; period && i < values.size(); ++i) {
            const double shift = *period * std::floor(values[i] / *period);
            values[i] -= shift;
            unwrap[i] += shift;
        }
    };
    wrap_axis(p_.period_x, s_.x, unwrap_x_);
    wrap_axis(p_.period_y, s_.y, unwrap_y_);
}

void ScalarKernel::list_pairs() {
    carrier_.clear();
    for (const Pair& pair : pairs_) {
        if (pair.memory.nx != 0 || pair.memory.ny != 0) carrier_.keep(pair.i, pair.j, pair.memory);
    }
    wrap();
    std::vector<double> x, y, radius;
    for (const std::size_t i : places_) {
        x.push_back(s_.x[i]);
        y.push_back(s_.y[i]);
        radius.push_back(s_.radius[i]);
    }
    const std::vector<double> margins(mobile_, margin_);
    search_.find({.x = x,
                  .y = y,
                  .radius = radius,
                  .margin_x = margins,
                  .margin_y = margins,
                  .mobile = mobile_});
    pairs_.clear();
    for (const NearPair& near : search_.pairs())
        pairs_.push_back(pair_of(near));
    listed_x_ = s_.x;
    listed_y_ = s_.y;
    ++builds_;
}

template <class Law>
void ScalarKernel::add_contact_forces(const Law& law, double spring_time) {
    for (Pair& pair : pairs_) {
        const std::size_t i = pair.i, j = pair.j;
        const double dx = s_.x[i] - s_.x[j] + pair.shift_x;
        const double dy = s_.y[i] - s_.y[j] + pair.shift_y;
        const double r_squared = dx * dx + dy * dy;
        const double reach = s_.radius[i] + s_.radius[j];
        if (!(r_squared < reach * reach)) {
            pair.memory = {};
            continue;
        }
        const double r = std::sqrt(r_squared);
        const ContactForce f = law(Touch{.overlap = reach - r,
                                         .nx = dx / r,
                                         .ny = dy / r,
                                         .vx = s_.vx[i] - s_.vx[j],
                                         .vy = s_.vy[i] - s_.vy[j],
                                         .radius_i = s_.radius[i],
                                         .radius_j = s_.radius[j],
                                         .omega_i = s_.omega[i],
                                         .omega_j = s_.omega[j],
                                         .damping = pair.damping,
                                         .tangential_damping = pair.tangential_damping},
                                   spring_time, pair.memory);
        ax_[i] += f.x;
        ay_[i] += f.y;
        alpha_[i] += f.torque_i;
        ax_[j] -= f.x;
        ay_[j] -= f.y;
        alpha_[j] += f.torque_j;
    }
}

/// Backing, drag and gravity, and the masses.
void ScalarKernel::add_other_forces() {
    for (std::size_t k = 0; k < mobile_; ++k) {
        const std::size_t i = places_[k];
        if (const auto& b = p_.backing) {
            ax_[i] += b->stiffness *
                      (std::max(b->left - s_.x[i], 0.0) - std::max(s_.x[i] - b->right, 0.0));
        }
        ax_[i] = (ax_[i] - p_.drag * s_.vx[i]) / s_.mass[i];
        ay_[i] = (ay_[i] - p_.drag * s_.vy[i]) / s_.mass[i] - p_.gravity;
        alpha_[i] /= p_.inertia_factor * s_.mass[i] * s_.radius[i] * s_.radius[i];
    }
}

/// `spring_time` is what the springs are stretched for: 0 at the start of a run.
void ScalarKernel::compute_accelerations(double spring_time) {
    for (auto* a : {&ax_, &ay_, &alpha_})
        std::fill(a->begin(), a->end(), 0.0);
    with_law_of(p_.contact, [&]<TangentialForce force, Conventions conventions>() {
        add_contact_forces(FrictionLaw<force, conventions>(p_.contact), spring_time);
    });
    add_other_forces();
    ++evaluations_;
}

void ScalarKernel::kick() {
    const double half = p_.dt / 2;
    for (std::size_t k = 0; k < mobile_; ++k) {
        const std::size_t i = places_[k];
        s_.vx[i] += ax_[i] * half;
        s_.vy[i] += ay_[i] * half;
        s_.omega[i] += alpha_[i] * half;
    }
}

void ScalarKernel::drift() {
    for (std::size_t k = 0; k < mobile_; ++k) {
        const std::size_t i = places_[k];
        s_.x[i] += s_.vx[i] * p_.dt;
        s_.y[i] += s_.vy[i] * p_.dt;
    }
}

void ScalarKernel::advance(std::int64_t steps) {
    for (std::int64_t n = 0; n < steps; ++n) {
        kick();
        drift();
        if (has_left_its_margin()) list_pairs();
        compute_accelerations(p_.dt);
        kick();
        ++s_.step;
    }
}

const State& ScalarKernel::state() {
    if (shown_.step == s_.step) return shown_;
    shown_ = s_;
    for (std::size_t i = 0; i < s_.x.size(); ++i) {
        shown_.x[i] += unwrap_x_[i];
        shown_.y[i] += unwrap_y_[i];
    }
    return shown_;
}

}  // namespace

std::unique_ptr<StepKernel> make_scalar_kernel(const Parameters& parameters, State state) {
    return std::make_unique<ScalarKernel>(parameters, std::move(state));
}

}  // namespace crossgrain::friction
