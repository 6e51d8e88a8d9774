// Frictional contacts of rotating discs that differ, integrated on their own: it shares nothing
// with the engines or the adapters, and each convention by which codes differ is a branch on its
// name. Written from the formulas, a double loop over all pairs, slow on purpose. No plates.
//
// Step: kick dt/2, drift dt, force from (x_{n+1}, v_{n+1/2}, omega_{n+1/2}), kick dt/2. Normal n
// from j to i, tangent t = (-n_y, n_x), overlap delta = r_i + r_j - |x_i - x_j|, lever l = r or r -
// delta/2:
//   F_n = k delta - eta v_n                            cut at 0 unless the scene says otherwise
//   v_t = (v_i - v_j) . t - l_i omega_i - l_j omega_j
//   xi' = v_t,  F_t = -k_t xi - gamma_t v_t,  |F_t| <= mu |F_n|
//   torque on i and on j: -l F_t
#pragma once

#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace crossgrain::tests {

/// Whether positions are kept inside the period, as many codes do. It is the same motion, but v dt
/// is rounded differently when it is added to a number of another size: 1e-10 after 10^4 steps.
enum class Coordinates { unwrapped, wrapped };

class ReferenceFriction {
  public:
    /// `scene` must have friction and no plates.
    ReferenceFriction(scene::Scene scene, scene::FrictionConventions conventions,
                      Coordinates coordinates = Coordinates::unwrapped)
        : scene_(std::move(scene)), friction_(scene_.contact.friction.value()),
          conventions_(conventions), coordinates_(coordinates), n_(scene_.grain_count()),
          x_(scene_.initial.x), y_(scene_.initial.y), turns_x_(n_), turns_y_(n_),
          vx_(scene_.initial.vx), vy_(scene_.initial.vy), omega_(scene_.initial.omega), fx_(n_),
          fy_(n_), torque_(n_) {
        omega_.resize(n_, 0.0);
        for (std::size_t i = 0; i < n_; ++i) {
            if (frozen(i)) vx_[i] = vy_[i] = omega_[i] = 0.0;
        }
    }

    /// The whole run, with frames at 0, frame_every, ..., steps.
    void run(const scene::FrameSink& sink) {
        find_forces(0.0);
        emit(0, sink);
        for (std::int64_t step = 1; step <= scene_.steps; ++step) {
            kick(scene_.dt / 2);
            for (std::size_t i = 0; i < n_; ++i) {
                x_[i] += vx_[i] * scene_.dt;
                y_[i] += vy_[i] * scene_.dt;
                wrap(x_[i], turns_x_[i], scene_.periodic_x);
                wrap(y_[i], turns_y_[i], scene_.periodic_y);
            }
            find_forces(scene_.dt);
            kick(scene_.dt / 2);
            if (step % scene_.frame_every == 0) emit(step, sink);
        }
    }

    /// Of all grains at this instant: kinetic and rotational.
    [[nodiscard]] double kinetic_energy() const {
        double energy = 0;
        for (std::size_t i = 0; i < n_; ++i) {
            energy += scene_.grains.mass_of(i) * (vx_[i] * vx_[i] + vy_[i] * vy_[i]) / 2 +
                      inertia(i) * omega_[i] * omega_[i] / 2;
        }
        return energy;
    }

    /// About the origin, of all grains at this instant: orbital and spin.
    [[nodiscard]] double angular_momentum() const {
        double sum = 0;
        for (std::size_t i = 0; i < n_; ++i) {
            sum += scene_.grains.mass_of(i) * (x_[i] * vy_[i] - y_[i] * vx_[i]) +
                   inertia(i) * omega_[i];
        }
        return sum;
    }

  private:
    /// What a contact remembers: the spring as a vector, and the normal at its last step.
    struct Spring {
        double x = 0, y = 0;
        double normal_x = 0, normal_y = 0;
    };

    struct Contact {
        std::size_t i, j;
        double nx, ny;  ///< normal from j to i
        double overlap;
        double dt;  ///< by which springs grow; 0 at the start
    };

    [[nodiscard]] bool frozen(std::size_t i) const {
        return !scene_.initial.frozen.empty() && scene_.initial.frozen[i];
    }
    [[nodiscard]] double radius(std::size_t i) const { return scene_.grains.diameter_of(i) / 2; }
    [[nodiscard]] double inertia(std::size_t i) const {
        return friction_.inertia_factor * scene_.grains.mass_of(i) * radius(i) * radius(i);
    }
    [[nodiscard]] double lever(scene::Lever kind, std::size_t i, double overlap) const {
        return kind == scene::Lever::radius ? radius(i) : radius(i) - overlap / 2;
    }

    void wrap(double& position, double& turns, const std::optional<double>& period) const {
        if (!period || coordinates_ == Coordinates::unwrapped) return;
        const double whole = std::floor(position / *period);
        position -= whole * *period;
        turns += whole;
    }

    /// By which dashpots of this pair are multiplied.
    [[nodiscard]] double damping_scale(std::size_t i, std::size_t j) const {
        if (scene_.contact.damping_scale == scene::DampingScale::absolute) return 1;
        const double mi = scene_.grains.mass_of(i), mj = scene_.grains.mass_of(j);
        if (frozen(i)) return mj;
        return frozen(j) ? mi : mi * mj / (mi + mj);
    }

    void kick(double dt) {
        for (std::size_t i = 0; i < n_; ++i) {
            if (frozen(i)) continue;
            vx_[i] += fx_[i] / scene_.grains.mass_of(i) * dt;
            vy_[i] += fy_[i] / scene_.grains.mass_of(i) * dt;
            omega_[i] += torque_[i] / inertia(i) * dt;
        }
    }

    void find_forces(double dt) {
        for (std::size_t i = 0; i < n_; ++i) {
            fx_[i] = -scene_.drag * vx_[i];
            fy_[i] = -scene_.drag * vy_[i] - scene_.gravity * scene_.grains.mass_of(i);
            torque_[i] = 0;
            if (!scene_.backing) continue;
            const auto& planes = *scene_.backing;
            if (x_[i] < planes.left) fx_[i] += planes.stiffness * (planes.left - x_[i]);
            if (x_[i] > planes.right) fx_[i] -= planes.stiffness * (x_[i] - planes.right);
        }
        for (std::size_t i = 0; i < n_; ++i) {
            for (std::size_t j = i + 1; j < n_; ++j) {
                if (!(frozen(i) && frozen(j))) add_pair(i, j, dt);
            }
        }
    }

    void add_pair(std::size_t i, std::size_t j, double dt) {
        const double dx = scene::nearest_image(x_[i] - x_[j], scene_.periodic_x);
        const double dy = scene::nearest_image(y_[i] - y_[j], scene_.periodic_y);
        const double r = std::sqrt(dx * dx + dy * dy);
        const double overlap = radius(i) + radius(j) - r;
        if (overlap <= 0) {
            springs_.erase({i, j});
            return;
        }
        const Contact contact{i, j, dx / r, dy / r, overlap, dt};
        const double nx = contact.nx, ny = contact.ny;
        const double vx = vx_[i] - vx_[j], vy = vy_[i] - vy_[j];
        double normal = scene_.contact.stiffness * overlap -
                        scene_.contact.damping * damping_scale(i, j) * (vx * nx + vy * ny);
        if (normal < 0 && scene_.contact.clipping != scene::Clipping::none) normal = 0;
        const auto arm = conventions_.velocity_lever;
        const double slip = -vx * ny + vy * nx - lever(arm, i, overlap) * omega_[i] -
                            lever(arm, j, overlap) * omega_[j];
        const double limit = friction_.coefficient * std::abs(normal);
        const auto [tx, ty] = friction_.force == scene::TangentialForce::spring
                                  ? spring_force(contact, slip, limit)
                                  : dashpot_force(contact, slip, limit);
        fx_[i] += normal * nx + tx, fy_[i] += normal * ny + ty;
        fx_[j] -= normal * nx + tx, fy_[j] -= normal * ny + ty;
        const double twist = nx * ty - ny * tx;
        torque_[i] -= lever(conventions_.torque_lever, i, overlap) * twist;
        torque_[j] -= lever(conventions_.torque_lever, j, overlap) * twist;
    }

    [[nodiscard]] std::pair<double, double> dashpot_force(const Contact& contact, double slip,
                                                          double limit) const {
        double force = -friction_.damping * damping_scale(contact.i, contact.j) * slip;
        if (std::abs(force) > limit) force = std::copysign(limit, force);
        return {-force * contact.ny, force * contact.nx};
    }

    /// Lets the spring grow and slide; returns the tangential force on i.
    std::pair<double, double> spring_force(const Contact& contact, double slip, double limit) {
        Spring& spring = springs_[{contact.i, contact.j}];
        turn(spring, contact);
        spring.x -= slip * contact.dt * contact.ny;
        spring.y += slip * contact.dt * contact.nx;
        const double k_t = friction_.stiffness;
        const double drag = friction_.damping * damping_scale(contact.i, contact.j) * slip;
        const double drag_x = -drag * contact.ny, drag_y = drag * contact.nx;
        double fx = -k_t * spring.x, fy = -k_t * spring.y;
        const bool total = conventions_.limit == scene::CoulombLimit::total;
        if (total) fx -= drag_x, fy -= drag_y;
        const double size = std::hypot(fx, fy);
        if (size > limit) {
            fx *= limit / size, fy *= limit / size;
            spring.x = -(fx + (total ? drag_x : 0)) / k_t;
            spring.y = -(fy + (total ? drag_y : 0)) / k_t;
        } else if (!total) {
            fx -= drag_x, fy -= drag_y;
        }
        return {fx, fy};
    }

    /// The spring follows the normal from where it was in the step before.
    void turn(Spring& spring, const Contact& contact) const {
        const double nx = contact.nx, ny = contact.ny;
        if (conventions_.rotation == scene::SpringRotation::rotate) {
            const double sine = spring.normal_x * ny - spring.normal_y * nx;
            const double x = spring.x, y = spring.y;
            spring.x -= y * sine;
            spring.y += x * sine;
        } else {
            const double length = std::hypot(spring.x, spring.y);
            const double along = spring.x * nx + spring.y * ny;
            spring.x -= along * nx, spring.y -= along * ny;
            const double left = std::hypot(spring.x, spring.y);
            if (conventions_.rotation == scene::SpringRotation::project_and_rescale && left > 0) {
                spring.x *= length / left, spring.y *= length / left;
            }
        }
        spring.normal_x = nx, spring.normal_y = ny;
    }

    void emit(std::int64_t step, const scene::FrameSink& sink) const {
        auto x = x_, y = y_;
        for (std::size_t i = 0; i < n_; ++i) {
            x[i] += turns_x_[i] * scene_.periodic_x.value_or(0);
            y[i] += turns_y_[i] * scene_.periodic_y.value_or(0);
        }
        sink({.step = step,
              .time = static_cast<double>(step) * scene_.dt,
              .x = x,
              .y = y,
              .vx = vx_,
              .vy = vy_,
              .lid = {},
              .omega = omega_});
    }

    scene::Scene scene_;
    scene::Friction friction_;
    scene::FrictionConventions conventions_;
    Coordinates coordinates_;
    std::size_t n_;
    std::vector<double> x_, y_, turns_x_, turns_y_, vx_, vy_, omega_, fx_, fy_, torque_;
    std::map<std::pair<std::size_t, std::size_t>, Spring> springs_;
};

}  // namespace crossgrain::tests
