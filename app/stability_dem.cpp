#include "app/stability_dem.hpp"

#include "app/stability_scenes.hpp"

#include "adapters/native/native_dem_code.hpp"
#include "cases/measure/energy_balance.hpp"
#include "native/base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace crossgrain::app {
namespace {

using scene::Integrator;
using scene::Scene;

constexpr double other_restitution = 0.5;

struct Method {
    Integrator integrator;
    analytic::TimeScheme theory;
    bool stable_without_damping;
};

constexpr std::array methods{
    Method{Integrator::verlet_predicted, analytic::TimeScheme::predicted_verlet, true},
    Method{Integrator::verlet_half_step, analytic::TimeScheme::half_step_verlet, true},
    Method{Integrator::leapfrog_crank_nicolson, analytic::TimeScheme::crank_nicolson_leapfrog,
           true},
    Method{Integrator::semi_implicit_euler, analytic::TimeScheme::semi_implicit_euler, true},
    Method{Integrator::explicit_euler, analytic::TimeScheme::explicit_euler, false},
    Method{Integrator::taguchi_euler, analytic::TimeScheme::taguchi_euler, false},
    Method{Integrator::runge_kutta_4, analytic::TimeScheme::runge_kutta_4, true}};

/// Runs scenes in the project's own engine; nothing of a run is kept but what the sink keeps.
class Trial {
  public:
    explicit Trial(std::stop_token stop) : stop_(std::move(stop)), code_("stability") {}

    /// Whether the run came to its end; false if the trajectory left all bounds.
    bool run(const Scene& scene, const scene::FrameSink& sink) const {
        try {
            code_.run(scene, {.directory = {}, .time_limit = 600, .stop = stop_}, sink);
            return true;
        } catch (const AdapterError&) {
            return false;
        }
    }

  private:
    std::stop_token stop_;
    adapters::NativeDemCode code_;
};

double kinetic_energy(const scene::Frame& frame) {
    double sum = 0;
    for (std::size_t i = 0; i < frame.vx.size(); ++i)
        sum += frame.vx[i] * frame.vx[i] + frame.vy[i] * frame.vy[i];
    return sum;
}

/// Whether the kinetic energy does not rise again from its least value, which is that of the modes
/// that grow and of those that have not died away yet.
bool is_stable(const Trial& trial, Scene packing, double dt) {
    constexpr std::int64_t steps = 6000, frames = 40;
    constexpr double rise = 3;       // undamped, a sum over hundreds of modes fluctuates by percent
    constexpr double floor = 1e-10;  // of the energy at the start; below is round-off
    packing.dt = dt;
    packing.steps = steps;
    packing.frame_every = steps / frames;
    double first = 0, least = 0, last = 0;
    const bool finished = trial.run(packing, [&](const scene::Frame& frame) {
        last = kinetic_energy(frame);
        if (frame.step == 0) first = least = last;
        least = std::min(least, last);
    });
    return finished && !(last > rise * least && last > floor * first);
}

std::string method_name(const Scene& packing, double restitution, ContactState state) {
    return fmt::format("{}, e = {:g}, {} damping, {} contacts{}",
                       scene::to_string(packing.integrator), restitution,
                       scene::to_string(packing.contact.damping_acts_on),
                       state == ContactState::closed ? "closed" : "open",
                       packing.plates.bottom ? " between plates" : "");
}

/// Brackets the threshold in steps of 1.3 from `guess` on, then bisects to half a percent.
StabilityThreshold threshold(const Trial& trial, const Scene& packing, double guess) {
    constexpr double near = 1.03, step = 1.3, resolution = 0.005;
    StabilityThreshold result{
        .code = "native-dem", .parameter = "dt", .works = guess / near, .fails = guess * near};
    while (!is_stable(trial, packing, result.works)) {
        result.fails = result.works;
        result.works /= step;
        if (result.works < 1e-6 * guess) return result;
    }
    while (is_stable(trial, packing, result.fails)) {
        result.works = result.fails;
        result.fails *= step;
    }
    while (result.fails - result.works > resolution * result.works) {
        const double middle = (result.works + result.fails) / 2;
        (is_stable(trial, packing, middle) ? result.works : result.fails) = middle;
    }
    return result;
}

/// Whether the engine's iteration for the implicit velocities of Crank-Nicolson damping ends before
/// the scheme does: its hundred rounds gain 1e-14 if dt/2 times the largest rate of the dashpots,
/// 9 eta/m in a triangular lattice (6 eta/m normal only), is below 0.72.
bool limited_by_solver(const Scene& packing, double dt) {
    if (packing.integrator != Integrator::leapfrog_crank_nicolson) return false;
    const bool full = packing.contact.damping_acts_on == scene::Damping::full_vector;
    return dt / 2 * (full ? 9 : 6) * packing.contact.damping / packing.grains.mass > 0.72;
}

void add_threshold(const Trial& trial, const Scene& model, const Method& method, double restitution,
                   ContactState state, StabilityReport& report) {
    Scene with_law = model;
    with_law.contact = with_restitution(model, restitution);
    Scene packing = packing_scene(with_law, state);
    packing.integrator = method.integrator;
    const auto& law = packing.contact;
    const double in_lattice = analytic::lattice_time_step_limit(
        method.theory, law.stiffness, law.damping, packing.grains.mass,
        law.damping_acts_on == scene::Damping::full_vector ? analytic::Damping::full_vector
                                                           : analytic::Damping::normal_only);
    StabilityThreshold found = threshold(trial, packing, in_lattice);
    found.method = method_name(packing, restitution, state);
    found.tolerance = 0.03;
    if (state == ContactState::closed && !limited_by_solver(packing, in_lattice)) {
        if (!packing.plates.bottom) {
            found.theory = in_lattice;
            found.theory_source = "analytic:lattice_time_step_limit";
        } else if (const auto limit =
                       analytic::packing_time_step_limit(method.theory, closed_packing(packing))) {
            found.theory = limit;
            found.theory_source = "analytic:packing_time_step_limit";
        }
    }
    report.thresholds.push_back(std::move(found));
}

void add_thresholds(const Trial& trial, const Scene& given, StabilityReport& report) {
    const double own =
        std::exp(-given.contact.damping / given.grains.mass * scene::contact_time(given));
    for (const Method& method : methods) {
        for (const auto damping : {scene::Damping::full_vector, scene::Damping::normal_only}) {
            Scene model = given;
            model.contact.damping_acts_on = damping;
            for (const double restitution : {own, other_restitution}) {
                add_threshold(trial, model, method, restitution, ContactState::closed, report);
            }
            add_threshold(trial, model, method, own, ContactState::open, report);
        }
        if (method.stable_without_damping) {
            add_threshold(trial, given, method, 1, ContactState::closed, report);
        }
    }
}

void add_residual(const Trial& trial, Scene scene, double dt, StabilityReport& report) {
    scene.dt = dt;
    scene.frame_every = 1;
    scene.steps = std::llround(3 * scene.plates.bottom->period / dt);
    // Powers are sampled eight times per 0.008 or per step, so that the sum does not decide.
    measure::EnergyBalanceOptions options;
    options.samples_per_frame = dt < 0.02 * scene::contact_time(scene) ? 2 : 8;
    options.least_frames_per_contact_time = 0;
    measure::EnergyBalance balance(scene, options);
    const bool finished = trial.run(scene, [&](const scene::Frame& frame) { balance.add(frame); });
    StabilityPoint point{.code = "native-dem",
                         .at = {{"dt", dt}},
                         .in = {{"integrator", scene::to_string(scene.integrator)}},
                         .state = "blow-up",
                         .detail = "a grain has left all bounds"};
    if (finished) {
        measure::Results results;
        balance.finish(results);
        for (const auto& m : results.measurements) {
            if (m.observable != "energy_residual") continue;
            point.state = measure::energy_state(m.value, 0.01);
            point.detail = fmt::format("energy residual {:+.3g} %", 100 * m.value);
        }
    }
    report.points.push_back(std::move(point));
}

void add_residuals(const Trial& trial, const Scene& given, const std::stop_token& stop,
                   StabilityReport& report) {
    constexpr std::array steps_in_contact_time{100.0, 50.0, 25.0, 12.5, 8.0, 5.0, 3.5, 3.0};
    for (const Method& method : methods) {
        for (const double steps : steps_in_contact_time) {
            if (stop.stop_requested()) return;
            Scene scene = narrow_scene(given);
            scene.integrator = method.integrator;
            add_residual(trial, scene, scene::contact_time(scene) / steps, report);
        }
    }
}

}  // namespace

StabilityReport stability_dem(const catalog::Case& the_case, const Settings& settings,
                              std::stop_token stop) {
    StabilityReport report{.case_name = the_case.name};
    const Scene given = the_case.grain_scene(0, 0, settings.seed);
    const Trial trial(stop);
    try {
        add_thresholds(trial, given, report);
        add_residuals(trial, given, stop, report);
    } catch (const Interrupted&) {
        // What has been found so far is reported.
    }
    return report;
}

}  // namespace crossgrain::app
