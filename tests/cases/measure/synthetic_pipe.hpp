// Grains in a periodic pipe that carry a density wave of any shape, speed and mean velocity,
// exactly as conservation of grains wants it:
//
//   rho(x, t) = rho_0 f(x - v t),   J = rho_0 V + v (rho - rho_0),   u = J/rho,
//
// x downward. In the frame of the wave a grain's share of the mass above it, M(xi) = int f/L, grows
// at the constant rate (V - v)/L, so that its position is the inverse of M.
#pragma once

#include "cases/measure/estimator.hpp"
#include "native/base/random.hpp"
#include "tests/cases/measure/synthetic_frame.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace crossgrain::tests {

/// A pipe of diameter-1 grains between two columns of frozen ones, clear width 10. Mobile grains
/// come first. Frames every 0.2, up to `time`.
inline scene::Scene pipe_scene(std::size_t grains, double length = 220, double time = 500) {
    scene::Scene scene = plain_scene(grains);
    scene.grains.diameter = 1;
    scene.gravity = 1;
    scene.periodic_y = length;
    scene.dt = 0.01;
    scene.frame_every = 20;
    scene.steps = std::llround(time / scene.dt);
    auto& state = scene.initial;
    state.frozen.assign(grains, false);
    for (const double x : {0.0, 11.0}) {
        for (double y = 0; y < length - 1; y += 2) {
            state.x.push_back(x);
            state.y.push_back(y);
            state.vx.push_back(0);
            state.vy.push_back(0);
            state.frozen.push_back(true);
        }
    }
    return scene;
}

struct PipeWaveSpec {
    double speed = 8.24;     ///< V
    double velocity = 11.3;  ///< v
    /// f(xi/L) on [0, 1), > 0, mean 1.
    std::function<double(double)> shape = [](double) { return 1.0; };
    double thermal = 0;    ///< standard deviation of each component of the velocities' noise
    double diffusion = 0;  ///< random step of a grain per frame (l)
    /// Share of the grains that follow the pattern at time t; the others are anywhere.
    std::function<double(double)> following = [](double) { return 1.0; };
    std::uint64_t seed = 1;
};

inline std::function<double(double)> cosine_wave(double amplitude, int k = 1) {
    return [=](double xi) { return 1 + amplitude * std::cos(2 * std::numbers::pi * k * xi); };
}

class SyntheticPipe {
  public:
    SyntheticPipe(const scene::Scene& scene, PipeWaveSpec spec)
        : scene_(scene), spec_(std::move(spec)), x_(scene.initial.x), y_(scene.initial.y),
          vx_(x_.size(), 0.0), vy_(x_.size(), 0.0), omega_(x_.size(), 0.0) {
        constexpr std::size_t points = 4000;
        mass_.push_back(0);
        for (std::size_t i = 0; i < points; ++i)
            mass_.push_back(mass_.back() + shape((static_cast<double>(i) + 0.5) / points));
        for (double& m : mass_)
            m /= mass_.back();
        for (std::size_t i = 0; i < x_.size(); ++i)
            share_.push_back(uniform(spec_.seed, RandomStream::initial_position, i));
    }

    /// Feeds every frame of the scene to the estimator.
    measure::Results run(measure::Estimator& estimator) {
        for (std::int64_t step = 0; step <= scene_.steps; step += scene_.frame_every) {
            place(step);
            estimator.add({.step = step,
                           .time = static_cast<double>(step) * scene_.dt,
                           .x = x_,
                           .y = y_,
                           .vx = vx_,
                           .vy = vy_,
                           .lid = {},
                           .omega = omega_});
        }
        measure::Results results;
        estimator.finish(results);
        return results;
    }

  private:
    [[nodiscard]] double shape(double xi) const { return spec_.shape(xi); }

    /// The place xi/L above which the share m of the mass lies.
    [[nodiscard]] double inverse(double m) const {
        const auto above = std::ranges::upper_bound(mass_, m);
        const auto i = static_cast<std::size_t>(above - mass_.begin()) - 1;
        const double part = (m - mass_[i]) / (mass_[i + 1] - mass_[i]);
        return (static_cast<double>(i) + part) / static_cast<double>(mass_.size() - 1);
    }

    void place(std::int64_t step) {
        const double length = *scene_.periodic_y, t = static_cast<double>(step) * scene_.dt;
        const double rate = (spec_.speed - spec_.velocity) / length;
        const auto frame = static_cast<std::uint64_t>(step / scene_.frame_every);
        for (std::size_t i = 0; i < x_.size(); ++i) {
            if (scene_.initial.frozen[i]) continue;
            const std::uint64_t n = frame * x_.size() + i;
            if (spec_.diffusion > 0) {
                share_[i] +=
                    spec_.diffusion / length * normal_pair(spec_.seed, RandomStream::jitter, n)[0];
            }
            const double m = share_[i] + rate * t;
            const double xi = inverse(m - std::floor(m));
            const auto noise = normal_pair(spec_.seed, RandomStream::initial_velocity, n);
            const double u = spec_.velocity + (spec_.speed - spec_.velocity) / shape(xi);
            y_[i] = -(xi * length + spec_.velocity * t);
            if (static_cast<double>(i) >= spec_.following(t) * static_cast<double>(x_.size())) {
                y_[i] = length * uniform(spec_.seed, RandomStream::signal, n);
            }
            vx_[i] = spec_.thermal * noise[0];
            vy_[i] = -u + spec_.thermal * noise[1];
            omega_[i] = i % 2 == 0 ? 3 : -1;
        }
    }

    scene::Scene scene_;
    PipeWaveSpec spec_;
    std::vector<double> x_, y_, vx_, vy_, omega_;
    std::vector<double> mass_, share_;
};

/// Grains thrown anew at each frame, all falling at `speed`: no wave, nothing is carried.
class RandomPipe {
  public:
    RandomPipe(const scene::Scene& scene, double speed, std::uint64_t seed)
        : scene_(scene), speed_(speed), seed_(seed) {}

    measure::Results run(measure::Estimator& estimator) {
        const std::size_t count = scene_.initial.x.size();
        std::vector<double> y(count), vy(count, -speed_);
        std::uint64_t n = 0;
        for (std::int64_t step = 0; step <= scene_.steps; step += scene_.frame_every) {
            for (double& one : y)
                one = *scene_.periodic_y * uniform(seed_, RandomStream::initial_position, n++);
            estimator.add({.step = step,
                           .time = static_cast<double>(step) * scene_.dt,
                           .x = scene_.initial.x,
                           .y = y,
                           .vx = scene_.initial.vx,
                           .vy = vy,
                           .lid = {},
                           .omega = {}});
        }
        measure::Results results;
        estimator.finish(results);
        return results;
    }

  private:
    scene::Scene scene_;
    double speed_;
    std::uint64_t seed_;
};

inline std::string label(const measure::Results& results, const std::string& finding) {
    for (const auto& one : results.findings) {
        if (one.name == finding) return one.label;
    }
    return {};
}

}  // namespace crossgrain::tests
