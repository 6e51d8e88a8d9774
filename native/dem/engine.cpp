#include "native/dem/engine.hpp"

#include "native/base/errors.hpp"
#include "native/dem/contact_law.hpp"
#include "native/dem/neighbour_list.hpp"
#include "native/dem/plates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <variant>

namespace crossgrain::dem {
namespace {

/// Half a diameter: the second shell of a dense packing stays out, rebuilds stay rare.
constexpr double skin_in_diameters = 0.5;

using Law =
    std::variant<SpringDashpot<DampingDirection::full_vector, AttractiveTail::kept>,
                 SpringDashpot<DampingDirection::full_vector, AttractiveTail::contact_force_cut>,
                 SpringDashpot<DampingDirection::full_vector, AttractiveTail::normal_force_cut>,
                 SpringDashpot<DampingDirection::normal_only, AttractiveTail::kept>,
                 SpringDashpot<DampingDirection::normal_only, AttractiveTail::contact_force_cut>,
                 SpringDashpot<DampingDirection::normal_only, AttractiveTail::normal_force_cut>>;

template <DampingDirection damping>
Law law_with(const Parameters& p) {
    switch (p.tail) {
    case AttractiveTail::kept:
        break;
    case AttractiveTail::contact_force_cut:
        return SpringDashpot<damping, AttractiveTail::contact_force_cut>{p.stiffness, p.damping};
    case AttractiveTail::normal_force_cut:
        return SpringDashpot<damping, AttractiveTail::normal_force_cut>{p.stiffness, p.damping};
    }
    return SpringDashpot<damping, AttractiveTail::kept>{p.stiffness, p.damping};
}

Law make_law(const Parameters& p) {
    return p.damping_direction == DampingDirection::full_vector
               ? law_with<DampingDirection::full_vector>(p)
               : law_with<DampingDirection::normal_only>(p);
}

}  // namespace

struct Engine::Implementation {
    Implementation(const Parameters& parameters, State initial);

    void advance(std::int64_t steps);
    template <class PairLaw>
    void step(const PairLaw& law);
    template <class PairLaw>
    void forces(const PairLaw& law, const std::vector<double>& vx, const std::vector<double>& vy);
    template <class PairLaw>
    void pair_forces(const PairLaw& law, const std::vector<double>& vx,
                     const std::vector<double>& vy);
    void plate_forces(double t);
    void accelerations_from_forces();
    void kick();
    void drift();
    void predict_velocities();

    Parameters p;
    State s;
    Law law;
    NeighbourList neighbours;
    std::vector<double> ax, ay;  ///< forces while they are summed up
    std::vector<double> vx_predicted, vy_predicted;
    double lid_acceleration = 0;
};

Engine::Implementation::Implementation(const Parameters& parameters, State initial)
    : p(parameters), s(std::move(initial)), law(make_law(p)),
      neighbours(p.diameter, skin_in_diameters * p.diameter, p.period_x, p.period_y),
      ax(s.x.size()), ay(s.x.size()) {
    for (const std::size_t i : s.frozen)
        s.vx[i] = s.vy[i] = 0;
    neighbours.update(s.x, s.y);
    std::visit([&](const auto& pair_law) { forces(pair_law, s.vx, s.vy); }, law);
}

void Engine::Implementation::advance(std::int64_t steps) {
    std::visit(
        [&](const auto& pair_law) {
            for (std::int64_t i = 0; i < steps; ++i)
                step(pair_law);
        },
        law);
}

template <class PairLaw>
void Engine::Implementation::step(const PairLaw& pair_law) {
    kick();
    drift();
    ++s.step;
    neighbours.update(s.x, s.y);
    if (p.scheme == Scheme::verlet_predicted) {
        predict_velocities();
        forces(pair_law, vx_predicted, vy_predicted);
    } else {
        forces(pair_law, s.vx, s.vy);
    }
    kick();
}

template <class PairLaw>
void Engine::Implementation::forces(const PairLaw& pair_law, const std::vector<double>& vx,
                                    const std::vector<double>& vy) {
    std::fill(ax.begin(), ax.end(), 0.0);
    std::fill(ay.begin(), ay.end(), 0.0);
    pair_forces(pair_law, vx, vy);
    plate_forces(static_cast<double>(s.step) * p.dt);
    accelerations_from_forces();
}

template <class PairLaw>
void Engine::Implementation::pair_forces(const PairLaw& pair_law, const std::vector<double>& vx,
                                         const std::vector<double>& vy) {
    const double d = p.diameter;
    for (const Pair& pair : neighbours.pairs()) {
        const std::size_t i = pair.i;
        const std::size_t j = pair.j;
        const double dx = s.x[i] - s.x[j] + pair.shift_x;
        const double dy = s.y[i] - s.y[j] + pair.shift_y;
        const double r_squared = dx * dx + dy * dy;
        if (r_squared >= d * d) continue;
        const double r = std::sqrt(r_squared);
        const Force f = pair_law(d - r, dx / r, dy / r, vx[i] - vx[j], vy[i] - vy[j]);
        ax[i] += f.x;
        ay[i] += f.y;
        ax[j] -= f.x;
        ay[j] -= f.y;
    }
}

void Engine::Implementation::plate_forces(double t) {
    if (p.bottom) {
        push_from_bottom(p.bottom->position(t), p.plate_stiffness, p.plate_reach, s.y, ay);
    }
    if (const auto* plate = std::get_if<MovingPlate>(&p.lid)) {
        push_from_lid(plate->position(t), p.plate_stiffness, p.plate_reach, s.y, ay);
    } else if (const auto* lid = std::get_if<InertialLid>(&p.lid)) {
        const double push = push_from_lid(s.lid_height, p.plate_stiffness, p.plate_reach, s.y, ay);
        lid_acceleration = push / lid->mass - p.gravity;
    }
}

void Engine::Implementation::accelerations_from_forces() {
    for (std::size_t i = 0; i < ax.size(); ++i) {
        ax[i] /= p.mass;
        ay[i] = ay[i] / p.mass - p.gravity;
    }
    for (const std::size_t i : s.frozen)
        ax[i] = ay[i] = 0;
}

void Engine::Implementation::kick() {
    const double half = p.dt / 2;
    for (std::size_t i = 0; i < ax.size(); ++i) {
        s.vx[i] += half * ax[i];
        s.vy[i] += half * ay[i];
    }
    s.lid_velocity += half * lid_acceleration;
}

void Engine::Implementation::drift() {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        s.x[i] += s.vx[i] * p.dt;
        s.y[i] += s.vy[i] * p.dt;
    }
    s.lid_height += s.lid_velocity * p.dt;
}

/// v_{n+1/2} + a_n dt/2; ax, ay still hold a_n.
void Engine::Implementation::predict_velocities() {
    const double half = p.dt / 2;
    vx_predicted.resize(ax.size());
    vy_predicted.resize(ax.size());
    for (std::size_t i = 0; i < ax.size(); ++i) {
        vx_predicted[i] = s.vx[i] + half * ax[i];
        vy_predicted[i] = s.vy[i] + half * ay[i];
    }
}

Engine::Engine(const Parameters& parameters, State state)
    : implementation_(std::make_unique<Implementation>(parameters, std::move(state))) {}

Engine::~Engine() = default;

void Engine::advance(std::int64_t steps) {
    implementation_->advance(steps);
}

const State& Engine::state() const noexcept {
    return implementation_->s;
}

}  // namespace crossgrain::dem
