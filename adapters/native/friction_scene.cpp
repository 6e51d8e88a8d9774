#include "adapters/native/friction_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace crossgrain::adapters {
namespace {

friction::Lever lever(scene::Lever value) {
    return value == scene::Lever::radius ? friction::Lever::radius : friction::Lever::contact_point;
}

friction::SpringRotation rotation(scene::SpringRotation value) {
    switch (value) {
    case scene::SpringRotation::project:
        break;
    case scene::SpringRotation::project_and_rescale:
        return friction::SpringRotation::project_and_rescale;
    case scene::SpringRotation::rotate:
        return friction::SpringRotation::rotate;
    }
    return friction::SpringRotation::project;
}

friction::Conventions conventions(const scene::Friction& law) {
    const auto wanted = law.conventions.value_or(scene::conventions_named("liggghts").value());
    return {.velocity_lever = lever(wanted.velocity_lever),
            .torque_lever = lever(wanted.torque_lever),
            .rotation = rotation(wanted.rotation),
            .limit = wanted.limit == scene::CoulombLimit::total
                         ? friction::CoulombLimit::total
                         : friction::CoulombLimit::spring_only};
}

friction::ContactParameters contact(const scene::ContactLaw& law) {
    friction::ContactParameters c{
        .stiffness = law.stiffness,
        .damping = law.damping,
        .damping_scale = law.damping_scale == scene::DampingScale::absolute
                             ? friction::DampingScale::absolute
                             : friction::DampingScale::effective_mass,
        // What is left of a cut normal force is nothing, and so is the friction it allows: the two
        // ways of cutting are the same here.
        .tail = law.clipping == scene::Clipping::none ? friction::AttractiveTail::kept
                                                      : friction::AttractiveTail::cut,
        .tangential = friction::TangentialForce::none,
        .conventions = {}};
    if (!law.friction) return c;
    c.tangential = law.friction->force == scene::TangentialForce::spring
                       ? friction::TangentialForce::spring
                       : friction::TangentialForce::dashpot;
    c.friction = law.friction->coefficient;
    c.tangential_stiffness = law.friction->stiffness;
    c.tangential_damping = law.friction->damping;
    c.conventions = conventions(*law.friction);
    return c;
}

}  // namespace

bool needs_friction_engine(const scene::Scene& scene) {
    return scene.has_friction() || scene.grains.differ() || scene.drag != 0 || scene.backing ||
           scene.contact.damping_scale == scene::DampingScale::effective_mass;
}

std::optional<std::string> friction_cannot_express(const scene::Scene& scene) {
    const char* const where =
        "with friction, grains that differ, drag, backing planes or damping per effective mass, "
        "native-dem";
    if (scene.contact.damping_acts_on != scene::Damping::normal_only) {
        return fmt::format("{} has no full-vector damping; damping = \"normal-only\" would be "
                           "expressible",
                           where);
    }
    // Without friction nothing turns a disc: spins may be on or off.
    if (scene.has_friction() && scene.contact.spins == scene::Spins::off) {
        return "native-dem's discs rotate when there is friction; spins = \"on\" would be "
               "expressible";
    }
    if (scene.backing && scene.periodic_x) {
        return "native-dem has no backing planes along x with a period along x; one of the two "
               "would be expressible";
    }
    if (scene.plates.bottom || !std::holds_alternative<std::monostate>(scene.plates.lid)) {
        return fmt::format("{} has no plates; frozen grains would be expressible", where);
    }
    if (scene.integrator != scene::Integrator::verlet_half_step) {
        return fmt::format("{} has no integrator \"{}\"; \"verlet-half-step\" would be expressible",
                           where, to_string(scene.integrator));
    }
    if (scene.skin) {
        return fmt::format("{} has its own skin; leaving it out would be expressible", where);
    }
    if (scene.contacts != scene::Contacts::neighbour_list) {
        return fmt::format("{} has no fixed neighbours; contacts = \"neighbour-list\" would be "
                           "expressible",
                           where);
    }
    if (scene.precision != scene::Precision::double_precision) {
        return fmt::format("{} has no mixed precision; precision = \"double\" would be expressible",
                           where);
    }
    for (const auto& period : {scene.periodic_x, scene.periodic_y}) {
        if (period && *period < 3 * scene::largest_diameter(scene.grains)) {
            return "a period below 3 diameters: a grain would meet two images of another";
        }
    }
    return std::nullopt;
}

friction::Parameters friction_parameters(const scene::Scene& scene) {
    friction::Parameters p{.contact = contact(scene.contact),
                           .gravity = scene.gravity,
                           .drag = scene.drag,
                           .period_x = scene.periodic_x,
                           .period_y = scene.periodic_y,
                           .dt = scene.dt};
    if (scene.has_friction()) p.inertia_factor = scene.contact.friction->inertia_factor;
    if (const auto& planes = scene.backing) {
        p.backing = friction::BackingPlanes{
            .stiffness = planes->stiffness, .left = planes->left, .right = planes->right};
    }
    return p;
}

friction::State friction_initial_state(const scene::Scene& scene) {
    const auto& start = scene.initial;
    const std::size_t grains = scene.grain_count();
    friction::State state{.x = start.x,
                          .y = start.y,
                          .vx = start.vx,
                          .vy = start.vy,
                          .omega = start.omega,
                          .radius = {},
                          .mass = {},
                          .frozen = {}};
    state.omega.resize(grains, 0.0);
    for (std::size_t i = 0; i < grains; ++i) {
        state.radius.push_back(scene.grains.diameter_of(i) / 2);
        state.mass.push_back(scene.grains.mass_of(i));
        if (!start.frozen.empty() && start.frozen[i]) state.frozen.push_back(i);
    }
    return state;
}

scene::Frame frame_of(const friction::State& state, const scene::Scene& scene) {
    scene::Frame frame{.step = state.step,
                       .time = static_cast<double>(state.step) * scene.dt,
                       .x = state.x,
                       .y = state.y,
                       .vx = state.vx,
                       .vy = state.vy,
                       .lid = std::nullopt};
    if (scene.has_friction()) frame.omega = state.omega;
    return frame;
}

}  // namespace crossgrain::adapters
