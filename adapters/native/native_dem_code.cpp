#include "adapters/native/native_dem_code.hpp"

#include "adapters/dump/dump_writer.hpp"
#include "adapters/dump/zstd_file.hpp"
#include "adapters/native/friction_scene.hpp"
#include "adapters/supervisor.hpp"
#include "cases/scene/frame_guard.hpp"
#include "cases/scene/scene_json.hpp"
#include "native/base/errors.hpp"
#include "native/dem/engine.hpp"
#include "native/friction/engine.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numbers>
#include <optional>

namespace crossgrain::adapters {
namespace {

dem::MovingPlate moving_plate(const scene::PrescribedPlate& plate) {
    return {.height = plate.height,
            .amplitude = plate.amplitude,
            .omega = 2.0 * std::numbers::pi / plate.period,
            .phase = scene::phase_angle(plate)};
}

dem::AttractiveTail tail(scene::Clipping clipping) {
    switch (clipping) {
    case scene::Clipping::none:
        break;
    case scene::Clipping::all:
        return dem::AttractiveTail::contact_force_cut;
    case scene::Clipping::normal_only:
        return dem::AttractiveTail::normal_force_cut;
    }
    return dem::AttractiveTail::kept;
}

dem::Scheme scheme(scene::Integrator integrator) {
    switch (integrator) {
    case scene::Integrator::verlet_half_step:
        break;
    case scene::Integrator::verlet_predicted:
        return dem::Scheme::verlet_predicted;
    case scene::Integrator::leapfrog_crank_nicolson:
        return dem::Scheme::leapfrog_crank_nicolson;
    case scene::Integrator::semi_implicit_euler:
        return dem::Scheme::semi_implicit_euler;
    case scene::Integrator::explicit_euler:
        return dem::Scheme::explicit_euler;
    case scene::Integrator::runge_kutta_4:
        return dem::Scheme::runge_kutta_4;
    case scene::Integrator::taguchi_euler:
        return dem::Scheme::taguchi_euler;
    case scene::Integrator::taguchi_adaptive_euler:
        return dem::Scheme::taguchi_adaptive_euler;
    }
    return dem::Scheme::verlet_half_step;
}

dem::Parameters parameters(const scene::Scene& scene) {
    dem::Parameters p{
        .diameter = scene.grains.diameter,
        .mass = scene.grains.mass,
        .stiffness = scene.contact.stiffness,
        .damping = scene.contact.damping,
        .damping_direction = scene.contact.damping_acts_on == scene::Damping::full_vector
                                 ? dem::DampingDirection::full_vector
                                 : dem::DampingDirection::normal_only,
        .tail = tail(scene.contact.clipping),
        .gravity = scene.gravity,
        .period_x = scene.periodic_x,
        .period_y = scene.periodic_y,
        .plate_stiffness = scene.plates.stiffness,
        .plate_reach =
            scene.plates.touches == scene::PlateContact::surface ? scene.grains.diameter / 2 : 0.0,
        .bottom = std::nullopt,
        .lid = {},
        .scheme = scheme(scene.integrator),
        .dt = scene.dt,
        .contacts = scene.contacts == scene::Contacts::neighbour_list
                        ? dem::Contacts::neighbour_list
                        : dem::Contacts::lattice_neighbours,
        .precision = scene.precision == scene::Precision::double_precision
                         ? dem::Precision::double_precision
                         : dem::Precision::mixed,
        .skin = scene.skin.value_or(0)};
    if (scene.plates.bottom) p.bottom = moving_plate(*scene.plates.bottom);
    if (const auto* plate = std::get_if<scene::PrescribedPlate>(&scene.plates.lid)) {
        p.lid = moving_plate(*plate);
    } else if (const auto* lid = std::get_if<scene::FreeLid>(&scene.plates.lid)) {
        p.lid = dem::InertialLid{.mass = lid->mass};
    }
    return p;
}

dem::State initial_state(const scene::Scene& scene) {
    dem::State state{
        .x = scene.initial.x, .y = scene.initial.y, .vx = scene.initial.vx, .vy = scene.initial.vy};
    for (std::size_t i = 0; i < scene.initial.frozen.size(); ++i) {
        if (scene.initial.frozen[i]) state.frozen.push_back(i);
    }
    if (const auto* lid = std::get_if<scene::FreeLid>(&scene.plates.lid)) {
        state.lid_height = lid->height;
        state.lid_velocity = lid->velocity;
    }
    return state;
}

using adapters::frame_of;  // of friction::State

scene::Frame frame_of(const dem::State& state, const scene::Scene& scene) {
    scene::Frame frame{.step = state.step,
                       .time = static_cast<double>(state.step) * scene.dt,
                       .x = state.x,
                       .y = state.y,
                       .vx = state.vx,
                       .vy = state.vy,
                       .lid = std::nullopt};
    if (scene.has_free_lid()) frame.lid = scene::LidState{state.lid_height, state.lid_velocity};
    return frame;
}

template <class Engine>
void stream_frames(Engine&& engine, const scene::Scene& scene, const Supervisor& supervisor,
                   scene::FrameGuard& guard) {
    constexpr std::int64_t block = 1000;  // steps between two looks at the clock
    guard(frame_of(engine.state(), scene));
    for (std::int64_t next = scene.frame_every; next <= scene.steps; next += scene.frame_every) {
        while (engine.state().step < next) {
            supervisor.check();
            engine.advance(std::min(block, next - engine.state().step));
        }
        guard(frame_of(engine.state(), scene));
    }
    guard.finish();
}

void stream_frames(const scene::Scene& scene, const Supervisor& supervisor,
                   scene::FrameGuard& guard) {
    if (needs_friction_engine(scene)) {
        stream_frames(friction::Engine(friction_parameters(scene), friction_initial_state(scene)),
                      scene, supervisor, guard);
    } else {
        stream_frames(dem::Engine(parameters(scene), initial_state(scene)), scene, supervisor,
                      guard);
    }
}

}  // namespace

NativeDemCode::NativeDemCode(std::string version) : version_(std::move(version)) {}

Availability NativeDemCode::probe(std::stop_token /*stop*/) const {
    return {.installed = true, .version = version_, .reason = {}};
}

std::vector<std::string> NativeDemCode::features() const {
    return {"contact: spring-dashpot, full-vector or normal-only damping",
            "clipping: none, all, normal-only",
            "spins: off; on with friction",
            "friction: spring or dashpot, every combination of the conventions (own: liggghts's); "
            "grains that differ, drag, backing planes, damping per effective mass: normal-only "
            "damping, no plates, neighbour-list, double, verlet-half-step",
            "plates: centre or surface; bottom at rest or prescribed; lid prescribed or free",
            "gravity, frozen grains, open or periodic along x and y",
            "contacts: neighbour-list, lattice-neighbours",
            "precision: double, mixed",
            "integrator: verlet-half-step, verlet-predicted, leapfrog-crank-nicolson, "
            "semi-implicit-euler, explicit-euler, runge-kutta-4, taguchi-euler, "
            "taguchi-adaptive-euler"};
}

std::optional<std::string> NativeDemCode::cannot_express(const scene::Scene& scene) const {
    if (needs_friction_engine(scene)) return friction_cannot_express(scene);
    if (scene.contact.spins == scene::Spins::on) {
        return "native-dem has no rotating discs without friction; spins = \"off\" would be "
               "expressible";
    }
    for (const auto& period : {scene.periodic_x, scene.periodic_y}) {
        if (period && *period < 3 * scene.grains.diameter) {
            return "a period below 3 diameters: a grain would meet two images of another";
        }
        if (period && *period < 3 * (scene.grains.diameter + scene.skin.value_or(0))) {
            return "a period below 3 (d + skin): a grain would be listed with two images of "
                   "another; a narrower skin would be expressible";
        }
    }
    if (scene.precision == scene::Precision::mixed) {
        if (const auto lack = dem::why_not_simd(parameters(scene), initial_state(scene))) {
            return fmt::format("mixed precision is not there for this scene: {}; precision = "
                               "\"double\" would be expressible",
                               *lack);
        }
    }
    return std::nullopt;
}

std::vector<InputFile> NativeDemCode::input(const scene::Scene& scene) const {
    return {{.name = "scene.json", .text = scene::to_json(scene).dump(1) + "\n"}};
}

RunCost NativeDemCode::run(const scene::Scene& scene, const RunOptions& options,
                           const scene::FrameSink& sink) const {
    const Supervisor supervisor(name(), options);
    std::optional<dump::ZstdFile> file;
    if (options.keep_dump) file.emplace(options.directory / kept_dump_name);
    const scene::FrameSink tee = [&](const scene::Frame& frame) {
        if (file) dump::DumpWriter(scene, *file)(frame);
        sink(frame);
    };
    try {
        scene::FrameGuard guard(scene, tee);
        stream_frames(scene, supervisor, guard);
        if (file && !file->finish()) throw supervisor.failure("the dump could not be written");
    } catch (const TrajectoryError& error) {
        throw supervisor.failure(error.what());
    } catch (const std::ios_base::failure& error) {
        throw supervisor.failure(error.what());
    }
    return supervisor.cost();
}

}  // namespace crossgrain::adapters
