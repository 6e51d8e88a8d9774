#include "cases/scene/motion_guard.hpp"

#include "cases/scene/step_resolution.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace crossgrain::scene {
namespace {

double speed_of(const PrescribedPlate& plate) {
    return 2 * std::numbers::pi * plate.amplitude / plate.period;
}

double fastest_plate(const Plates& plates) {
    double fastest = plates.bottom ? speed_of(*plates.bottom) : 0;
    if (const auto* lid = std::get_if<PrescribedPlate>(&plates.lid))
        fastest = std::max(fastest, speed_of(*lid));
    return fastest;
}

constexpr double of_double = 1e-9, of_mixed = 1e-6;

}  // namespace

MotionGuard::MotionGuard(const Scene& scene)
    : scene_(scene), tolerance_(scene.precision == Precision::mixed ? of_mixed : of_double),
      interval_(static_cast<double>(scene.frame_every) * scene.dt),
      plate_speed_(fastest_plate(scene.plates)),
      contacts_(largest_diameter(scene.grains), scene.periodic_x, scene.periodic_y) {}

void MotionGuard::check(const Frame& frame) {
    State now = state_of(frame);
    if (frames_ == 0) {
        if (const auto reason = why_not_resolved(scene_)) throw TrajectoryError(*reason);
        check_start(frame);
    } else {
        check_jumps(now, frame.step);
        check_flights(now, frame.step);
    }
    if (scene_.contacts == Contacts::neighbour_list) {
        check_speeds(frame);
        check_overlaps_and_energy(frame);
    }
    ++frames_;
    last_but_one_ = std::exchange(last_, std::move(now));
}

MotionGuard::State MotionGuard::state_of(const Frame& frame) const {
    State state{.x = {frame.x.begin(), frame.x.end()},
                .y = {frame.y.begin(), frame.y.end()},
                .vx = {frame.vx.begin(), frame.vx.end()},
                .vy = {frame.vy.begin(), frame.vy.end()}};
    if (frame.lid) {
        state.x.push_back(0);
        state.y.push_back(frame.lid->height);
        state.vx.push_back(0);
        state.vy.push_back(frame.lid->velocity);
    }
    for (std::size_t i = 0; i < state.x.size(); ++i)
        state.fastest = std::max(state.fastest, std::hypot(state.vx[i], state.vy[i]));
    return state;
}

std::string MotionGuard::name_of(std::size_t i) const {
    return i < scene_.grain_count() ? fmt::format("grain {}", i) : "the lid";
}

bool MotionGuard::is_frozen(std::size_t i) const {
    return i < scene_.initial.frozen.size() && scene_.initial.frozen[i];
}

void MotionGuard::check_start(const Frame& frame) const {
    const InitialState& initial = scene_.initial;
    const auto hold = [&](const char* what, std::span<const double> told,
                          const std::vector<double>& asked, double unit) {
        for (std::size_t i = 0; i < asked.size(); ++i) {
            if (is_frozen(i) && &asked != &initial.x && &asked != &initial.y) continue;  // at rest
            if (std::abs(told[i] - asked[i]) <= tolerance_ * (unit + std::abs(asked[i]))) continue;
            throw TrajectoryError(
                fmt::format("the first frame is not the scene's initial state: {} of grain {} is "
                            "{:.9g} instead of {:.9g} (another seed, another order of the grains?)",
                            what, i, told[i], asked[i]));
        }
    };
    // Of a velocity: a diameter in the time of a contact is fast.
    const double d = scene_.grains.diameter, fast = d / interval_ + d / scene_.dt * 1e-3;
    hold("x", frame.x, initial.x, d);
    hold("y", frame.y, initial.y, d);
    hold("vx", frame.vx, initial.vx, fast);
    hold("vy", frame.vy, initial.vy, fast);
    if (scene_.has_friction()) hold("omega", frame.omega, initial.omega, fast / d);
    if (const auto* lid = std::get_if<FreeLid>(&scene_.plates.lid)) {
        const bool same =
            std::abs(frame.lid->height - lid->height) <= tolerance_ * (d + std::abs(lid->height)) &&
            std::abs(frame.lid->velocity - lid->velocity) <=
                tolerance_ * (fast + std::abs(lid->velocity));
        if (!same) {
            throw TrajectoryError(fmt::format(
                "the lid of the first frame is at {:.9g} with velocity {:.9g}, the scene's at "
                "{:.9g} with {:.9g}",
                frame.lid->height, frame.lid->velocity, lid->height, lid->velocity));
        }
    }
}

/// Between two frames nothing moves further than some grain, the lid or a plate could take it.
void MotionGuard::check_jumps(const State& now, std::int64_t step) const {
    const double fastest = std::max(now.fastest, last_.fastest);
    const double in_reach = 4 * (fastest + plate_speed_ + scene_.gravity * interval_) * interval_ +
                            1e-6 * scene_.grains.diameter;
    for (std::size_t i = 0; i < now.x.size(); ++i) {
        const double moved = std::hypot(now.x[i] - last_.x[i], now.y[i] - last_.y[i]);
        if (moved <= in_reach) continue;
        throw TrajectoryError(fmt::format(
            "{} moves by {:.4g} up to step {}, no more than {:.4g} is possible at the velocities "
            "of the frames (wrapped by a period, swapped with another, or other units?)",
            name_of(i), moved, step, in_reach));
    }
}

bool MotionGuard::flew_by_velocities(const State& now, std::size_t i) const {
    const double fall = scene_.gravity * interval_;
    const double off = std::hypot(now.vx[i] - last_.vx[i], now.vy[i] - last_.vy[i] + fall);
    const double speed = std::hypot(now.vx[i], now.vy[i]) + fall;
    return off <= 10 * tolerance_ * speed && speed * interval_ > 1e-4 * scene_.grains.diameter;
}

bool MotionGuard::flew_by_positions(const State& now, std::size_t i) const {
    if (frames_ < 2) return false;
    const double fall = scene_.gravity * interval_ * interval_;
    const auto second = [](double a, double b, double c) { return a - 2 * b + c; };
    const double off = std::hypot(second(now.x[i], last_.x[i], last_but_one_.x[i]),
                                  second(now.y[i], last_.y[i], last_but_one_.y[i]) + fall);
    const double moved =
        std::hypot(now.x[i] - last_but_one_.x[i], now.y[i] - last_but_one_.y[i]) + fall;
    const double round_off = 1e-15 * (std::abs(now.x[i]) + std::abs(now.y[i])) + 1e-4 * fall;
    return off <= 100 * tolerance_ * moved + round_off && moved > 1e-3 * scene_.grains.diameter;
}

/// A single coincidence (two contacts that cancel) is no finding, most flights are.
void MotionGuard::check_flights(const State& now, std::int64_t step) {
    if (scene_.drag > 0) return;  // slows what flies
    constexpr std::int64_t enough = 3;
    for (std::size_t i = 0; i < now.x.size(); ++i) {
        if (is_frozen(i)) continue;
        Flights& flights = i < scene_.grain_count() ? of_grains_ : of_lid_;
        const auto hold = [&](double told, double expected, const char* relation) {
            // First-order schemes are off by g dt t.
            const double allowed = 1e-3 * std::abs(expected) +
                                   2 * scene_.gravity * scene_.dt * interval_ +
                                   1e-6 * scene_.grains.diameter;
            ++flights.all;
            if (std::abs(told - expected) <= allowed) return;
            ++flights.wrong;
            if (flights.wrong < enough || 2 * flights.wrong < flights.all) return;
            throw TrajectoryError(fmt::format(
                "{} flies freely up to step {} and comes {:.6g} far, where {} {:.6g} "
                "({} of {} such flights; another dt, or velocities of another time?)",
                name_of(i), step, told, relation, expected, flights.wrong, flights.all));
        };
        if (flew_by_velocities(now, i)) {
            hold(std::hypot(now.x[i] - last_.x[i], now.y[i] - last_.y[i]),
                 interval_ / 2 * std::hypot(now.vx[i] + last_.vx[i], now.vy[i] + last_.vy[i]),
                 "its velocities say");
        } else if (flew_by_positions(now, i)) {
            hold(std::hypot(now.x[i] - last_but_one_.x[i], now.y[i] - last_but_one_.y[i]),
                 2 * interval_ * std::hypot(last_.vx[i], last_.vy[i]),
                 "its velocity in the middle says");
        }
    }
}

/// Head on, a grain comes to rest within half a diameter of its like: v sqrt(m/(2k)) <= d/2.
void MotionGuard::check_speeds(const Frame& frame) const {
    for (std::size_t i = 0; i < frame.vx.size(); ++i) {
        const double d = scene_.grains.diameter_of(i), m = scene_.grains.mass_of(i);
        const double most = d / 2 * std::sqrt(2 * scene_.contact.stiffness / m);
        const double speed = std::hypot(frame.vx[i], frame.vy[i]);
        if (speed <= most) continue;
        throw TrajectoryError(fmt::format(
            "grain {} has velocity {:.3g} at step {}: contacts of stiffness {:g} stop no more than "
            "{:.3g} within half a diameter",
            i, speed, frame.step, scene_.contact.stiffness, most));
    }
}

double MotionGuard::elastic_at_plates(const Frame& frame) const {
    const Plates& plates = scene_.plates;
    double squares = 0;
    const auto add = [&](double overlap) { squares += overlap > 0 ? overlap * overlap : 0; };
    for (std::size_t i = 0; i < frame.y.size(); ++i) {
        if (is_frozen(i)) continue;
        const double reach =
            plates.touches == PlateContact::surface ? scene_.grains.diameter_of(i) / 2 : 0;
        if (plates.bottom) add(height_at(*plates.bottom, frame.time) + reach - frame.y[i]);
        if (frame.lid) add(frame.y[i] + reach - frame.lid->height);
        if (const auto* lid = std::get_if<PrescribedPlate>(&plates.lid))
            add(frame.y[i] + reach - height_at(*lid, frame.time));
    }
    double energy = plates.stiffness / 2 * squares;
    if (!scene_.backing) return energy;
    squares = 0;
    for (std::size_t i = 0; i < frame.x.size(); ++i) {
        if (is_frozen(i)) continue;
        add(scene_.backing->left - frame.x[i]);
        add(frame.x[i] - scene_.backing->right);
    }
    return energy + scene_.backing->stiffness / 2 * squares;
}

double MotionGuard::kinetic_and_potential(const Frame& frame, double& kinetic) const {
    double potential = 0;
    kinetic = 0;
    for (std::size_t i = 0; i < frame.x.size(); ++i) {
        if (is_frozen(i)) continue;
        const double m = scene_.grains.mass_of(i);
        kinetic += m / 2 * (frame.vx[i] * frame.vx[i] + frame.vy[i] * frame.vy[i]);
        if (const auto& friction = scene_.contact.friction) {
            const double rim = frame.omega[i] * scene_.grains.diameter_of(i) / 2;
            kinetic += friction->inertia_factor * m / 2 * rim * rim;
        }
        potential += m * scene_.gravity * frame.y[i];
    }
    if (const auto* lid = std::get_if<FreeLid>(&scene_.plates.lid)) {
        kinetic += lid->mass / 2 * frame.lid->velocity * frame.lid->velocity;
        potential += lid->mass * scene_.gravity * frame.lid->height;
    }
    return kinetic + potential;
}

void MotionGuard::check_overlaps_and_energy(const Frame& frame) {
    double squares = 0;
    for (const Contact& c : contacts_.find(frame.x, frame.y)) {
        if (is_frozen(c.i) && is_frozen(c.j)) continue;
        const double di = scene_.grains.diameter_of(c.i), dj = scene_.grains.diameter_of(c.j);
        const double overlap = (di + dj) / 2 - c.distance;
        if (overlap <= 0) continue;
        if (overlap > std::min(di, dj) / 2) {
            throw TrajectoryError(fmt::format(
                "grains {} and {} overlap by {:.3g} at step {}, more than half of a diameter: the "
                "contacts are too soft for these velocities, or dt = {:g} is too large",
                c.i, c.j, overlap, frame.step, scene_.dt));
        }
        squares += overlap * overlap;
    }
    if (plate_speed_ > 0) return;  // does work
    double kinetic = 0;
    // Tangential springs only take from this sum what they hold.
    const double energy = kinetic_and_potential(frame, kinetic) + elastic_at_plates(frame) +
                          scene_.contact.stiffness / 2 * squares;
    if (frames_ == 0) first_energy_ = energy;
    largest_kinetic_ = std::max(largest_kinetic_, kinetic);
    const double gain = energy - first_energy_;
    const double round_off = 1e-9 * (std::abs(first_energy_) + std::abs(energy));
    if (gain <= largest_kinetic_ / 2 + round_off) return;
    throw TrajectoryError(fmt::format(
        "the energy has risen by {:.3g} up to step {}, where nothing does work and no more than "
        "{:.3g} has ever moved: dt = {:g} is too large for the lightest grain or lid",
        gain, frame.step, largest_kinetic_, scene_.dt));
}

}  // namespace crossgrain::scene
