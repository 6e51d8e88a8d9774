// A tiny discrete-element integrator that shares nothing with the engines or the adapters: a plain
// double loop over all pairs, written from the formulas. It is what adapters and engines are held
// against, so that a wrong factor of two is seen. Slow on purpose (O(N^2) per step).
//
// Step: kick dt/2, drift dt, force from (x_{n+1}, v_{n+1/2}), kick dt/2. With the predicted variant
// the dashpots see v_{n+1/2} + a_n dt/2. Spins use the same step, the moment of inertia m R^2 / 2
// of a disc, and the point of contact half-way between the two centres.
#pragma once

#include "cases/scene/frame.hpp"
#include "cases/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace crossgrain::tests {

class ReferenceDem {
  public:
    explicit ReferenceDem(scene::Scene given)
        : scene_(std::move(given)), n_(scene_.grain_count()), x_(scene_.initial.x),
          y_(scene_.initial.y), vx_(scene_.initial.vx), vy_(scene_.initial.vy), spin_(n_, 0.0),
          ax_(n_), ay_(n_), spin_rate_(n_) {
        for (std::size_t i = 0; i < n_; ++i) {
            if (frozen(i)) vx_[i] = vy_[i] = 0.0;
        }
        if (const auto* lid = std::get_if<scene::FreeLid>(&scene_.plates.lid)) {
            lid_ = {.height = lid->height, .velocity = lid->velocity};
        }
    }

    /// The whole run, with frames at 0, frame_every, ..., steps.
    void run(const scene::FrameSink& sink) {
        accelerate(0.0, 0.0);
        emit(0, sink);
        for (std::int64_t step = 1; step <= scene_.steps; ++step) {
            const double half = 0.5 * scene_.dt;
            kick(half);
            drift(scene_.dt);
            const bool predicted = scene_.integrator == scene::Integrator::verlet_predicted;
            accelerate(static_cast<double>(step) * scene_.dt, predicted ? half : 0.0);
            kick(half);
            if (step % scene_.frame_every == 0) emit(step, sink);
        }
    }

  private:
    [[nodiscard]] bool frozen(std::size_t i) const {
        return scene_.has_frozen_grains() && scene_.initial.frozen[i];
    }

    void kick(double dt) {
        for (std::size_t i = 0; i < n_; ++i) {
            if (frozen(i)) continue;
            vx_[i] += ax_[i] * dt;
            vy_[i] += ay_[i] * dt;
            spin_[i] += spin_rate_[i] * dt;
        }
        lid_.velocity += lid_acceleration_ * dt;
    }

    void drift(double dt) {
        for (std::size_t i = 0; i < n_; ++i) {
            x_[i] += vx_[i] * dt;
            y_[i] += vy_[i] * dt;
        }
        lid_.height += lid_.velocity * dt;
    }

    /// Accelerations at time t; the dashpots see v + a_old * look_ahead.
    void accelerate(double t, double look_ahead) {
        const auto old_x = ax_, old_y = ay_, old_spin = spin_rate_;
        const auto ahead = [&](const auto& v, const auto& a, std::size_t i) {
            return frozen(i) ? v[i] : v[i] + look_ahead * a[i];
        };
        std::fill(ax_.begin(), ax_.end(), 0.0);
        std::fill(ay_.begin(), ay_.end(), -scene_.gravity);
        std::fill(spin_rate_.begin(), spin_rate_.end(), 0.0);
        for (std::size_t i = 0; i < n_; ++i) {
            for (std::size_t j = i + 1; j < n_; ++j) {
                add_pair(i, j, ahead(vx_, old_x, i) - ahead(vx_, old_x, j),
                         ahead(vy_, old_y, i) - ahead(vy_, old_y, j),
                         ahead(spin_, old_spin, i) + ahead(spin_, old_spin, j));
            }
        }
        add_plates(t);
    }

    void add_pair(std::size_t i, std::size_t j, double vx, double vy, double spins) {
        double dx = x_[i] - x_[j];
        if (scene_.periodic_x) dx -= *scene_.periodic_x * std::round(dx / *scene_.periodic_x);
        double dy = y_[i] - y_[j];
        if (scene_.periodic_y) dy -= *scene_.periodic_y * std::round(dy / *scene_.periodic_y);
        const double r = std::sqrt(dx * dx + dy * dy);
        if (r >= scene_.grains.diameter) return;
        const auto& law = scene_.contact;
        const bool rotating = law.spins == scene::Spins::on;
        const double nx = dx / r, ny = dy / r;  // normal from j to i; tangent (-ny, nx)
        const double lever = r / 2;
        double normal =
            law.stiffness * (scene_.grains.diameter - r) - law.damping * (vx * nx + vy * ny);
        double tangential = 0.0;
        if (law.damping_acts_on == scene::Damping::full_vector) {
            tangential = -law.damping * (vy * nx - vx * ny - (rotating ? lever * spins : 0.0));
        }
        if (normal < 0 && law.clipping != scene::Clipping::none) {
            normal = 0.0;
            if (law.clipping == scene::Clipping::all) tangential = 0.0;
        }
        const double m = scene_.grains.mass;
        const double fx = normal * nx - tangential * ny, fy = normal * ny + tangential * nx;
        ax_[i] += fx / m, ay_[i] += fy / m;
        ax_[j] -= fx / m, ay_[j] -= fy / m;
        if (!rotating) return;
        const double inertia = m * scene_.grains.diameter * scene_.grains.diameter / 8;
        spin_rate_[i] -= lever * tangential / inertia;
        spin_rate_[j] -= lever * tangential / inertia;
    }

    void add_plates(double t) {
        const auto& plates = scene_.plates;
        const bool surface = plates.touches == scene::PlateContact::surface;
        const double reach = surface ? scene_.grains.diameter / 2 : 0.0;
        const auto* prescribed_lid = std::get_if<scene::PrescribedPlate>(&plates.lid);
        const double top = prescribed_lid ? scene::height_at(*prescribed_lid, t) : lid_.height;
        double force_on_lid = 0.0;
        for (std::size_t i = 0; i < n_; ++i) {
            if (plates.bottom) {
                const double overlap = scene::height_at(*plates.bottom, t) - (y_[i] - reach);
                if (overlap > 0) ay_[i] += plates.stiffness * overlap / scene_.grains.mass;
            }
            if (!std::holds_alternative<std::monostate>(plates.lid)) {
                const double overlap = y_[i] + reach - top;
                if (overlap <= 0) continue;
                ay_[i] -= plates.stiffness * overlap / scene_.grains.mass;
                force_on_lid += plates.stiffness * overlap;
            }
        }
        if (const auto* lid = std::get_if<scene::FreeLid>(&plates.lid)) {
            lid_acceleration_ = force_on_lid / lid->mass - scene_.gravity;
        }
    }

    void emit(std::int64_t step, const scene::FrameSink& sink) const {
        scene::Frame frame{.step = step,
                           .time = static_cast<double>(step) * scene_.dt,
                           .x = x_,
                           .y = y_,
                           .vx = vx_,
                           .vy = vy_,
                           .lid = {}};
        if (scene_.has_free_lid()) frame.lid = lid_;
        sink(frame);
    }

    scene::Scene scene_;
    std::size_t n_;
    std::vector<double> x_, y_, vx_, vy_, spin_, ax_, ay_, spin_rate_;
    scene::LidState lid_;
    double lid_acceleration_ = 0;
};

}  // namespace crossgrain::tests
